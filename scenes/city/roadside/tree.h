#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

enum class Foliage { broad, fine, needles };
enum class Bark { brown, birch };

/// What kind of tree grows: shape of the crown and how it branches.
struct TreeSpecies {
  const char* name;
  double height_m, trunk_height_m;  ///< of a grown tree; where the crown begins
  double crown_radius_m;
  double trunk_radius_m;
  bool whorled = false;    ///< branches in whorls off one stem, as a spruce's
  double crown_top = 0.5;  ///< where the crown is widest: 0 at its foot, 1 at its top
  int limbs = 9;
  int cards = 900;  ///< leaf cards
  Foliage foliage = Foliage::broad;
  Bark bark = Bark::brown;
  double droop = 0;  ///< of the twigs: 0 they strive outwards, 1 they hang
};

/// By number in tree_species().
enum Species { lime, maple, plane, hornbeam, young, shrub, spruce, poplar, birch, pine, globe, plum };
const std::vector<TreeSpecies>& tree_species();

/// One tree, foot at the origin. Cards lie at the ends of the twigs, their normals bent outwards so that the
/// crown is lit as a volume.
Mesh tree(const TreeSpecies& species, MaterialId leaves, MaterialId bark, Stream stream);

/// A piece of clipped hedge along x around the origin.
Mesh hedge(const Materials& materials, double length_m, double height_m, Stream stream);

}  // namespace cps::city
