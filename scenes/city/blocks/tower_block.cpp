#include <algorithm>
#include <cmath>

#include "scenes/city/blocks/block_kinds.h"

namespace cps::city {

void fill_tower_block(BlockSite& site) {
  Draws& draws = site.draws;
  site.plan.ground = GroundKind::paving;
  const double setback = draws.chance(0.5) ? 0.0 : draws.uniform(1, 5);
  for (const Frontage& side : site.sides) {
    const double total = length(side.line);
    double s = draws.uniform(setback, setback + 4);
    while (s < total - 16) {
      const double width = std::min(draws.uniform(20, 46), total - s - setback);
      const LotFrame frame = lot_frame(side.line, s, width);
      BuildingPlan tower;
      tower.kind = BuildingKind::tower;
      tower.detached = true;
      tower.roof = RoofKind::flat;
      tower.storeys = static_cast<int>(6 + 26 * std::pow(draws.uniform(0, 1), 1.6));
      bool built = false;
      for (double depth = draws.uniform(22, 36); !built && depth > 13; depth *= 0.75) {
        tower.footprint = frame.footprint(-width / 2, width / 2, setback, setback + depth);
        built = width > 14 && try_building(site, tower);
      }
      s += built ? width + (draws.chance(0.4) ? 0.5 : draws.uniform(4, 14)) : 4;
    }
  }
  plant(site, 11 / site.character.tree_density, 3);
}

}  // namespace cps::city
