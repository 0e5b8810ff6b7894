#include <algorithm>

#include "scenes/city/blocks/block_kinds.h"

namespace cps::city {

void fill_slab_block(BlockSite& site) {
  Draws& draws = site.draws;
  const double setback = draws.uniform(4, 9);
  const int storeys = std::clamp(draw_storeys(site, 2, 7) + 2, 4, 8);
  for (const Frontage& side : site.sides) {
    const double total = length(side.line);
    double s = setback + draws.uniform(0, 6);
    while (s < total - setback - 14) {
      const double width = std::min(draws.uniform(18, 42), total - setback - s),
                   depth = draws.uniform(11, 14);
      BuildingPlan b;
      b.footprint = lot_frame(side.line, s, width).footprint(-width / 2, width / 2, setback, setback + depth);
      b.storeys = std::clamp(storeys + draws.integer(-1, 1), 3, 8);
      b.detached = true;
      b.roof = RoofKind::flat;
      try_building(site, b);
      s += width + draws.uniform(8, 16);
    }
  }
  plant(site, 10 / site.character.tree_density, 2.5);
}

}  // namespace cps::city
