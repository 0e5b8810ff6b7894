#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

enum class Foliage { broad, fine, needles };
enum class Bark { brown, birch };

/// A kind of tree: the shape of its crown and its branching.
struct TreeSpecies {
  const char* name;
  double height_m, trunk_height_m;  ///< height of the tree; of the crown's lower end
  double crown_radius_m;
  double trunk_radius_m;
  bool whorled = false;    ///< branches in whorls around one stem, as a spruce
  double crown_top = 0.5;  ///< relative height of the crown's widest part, 0 to 1
  int limbs = 9;
  int cards = 900;  ///< leaf cards
  Foliage foliage = Foliage::broad;
  Bark bark = Bark::brown;
  double droop = 0;  ///< of the twigs: 0 pointing outwards, 1 hanging
};

/// Indices into tree_species().
enum Species { lime, maple, plane, hornbeam, young, shrub, spruce, poplar, birch, pine, globe, plum };
const std::vector<TreeSpecies>& tree_species();

/// A tree with its foot at the origin. Leaf cards are at the ends of the twigs; their normals are bent
/// outwards, so that the crown is shaded like a volume.
Mesh tree(const TreeSpecies& species, MaterialId leaves, MaterialId bark, Stream stream);

/// A piece of clipped hedge along x, centred at the origin.
Mesh hedge(const Materials& materials, double length_m, double height_m, Stream stream);

}  // namespace cps::city
