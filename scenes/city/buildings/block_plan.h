#pragma once

#include "scenes/city/buildings/building.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

enum class BlockKind { closed, detached, slabs, park };

/// What one block is filled with; nothing of it overlaps anything else.
struct BlockPlan {
  BlockKind kind = BlockKind::closed;
  std::vector<double> pavement_m;  ///< per side
  Outline border;                  ///< where the pavements end
  std::vector<BuildingPlan> buildings;
  std::vector<Vec2> trees;       ///< in gardens, courts and parks
  std::vector<Polyline> hedges;  ///< along front gardens
};

/// How one seed's city leans: drawn once, felt in every block.
struct CityCharacter {
  double closed = 1, detached = 1, slabs = 1, park = 1;  ///< shares of block kinds
  double mean_storeys = 3.5, shop_share = 0.3, flat_roof_share = 0.3, tree_density = 1;
};
CityCharacter draw_character(std::uint64_t seed);

BlockPlan plan_block(const StreetNetwork& network, int block, const CityCharacter& character,
                     std::uint64_t seed);

}  // namespace cps::city
