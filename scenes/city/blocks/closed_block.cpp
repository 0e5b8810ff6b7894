#include <algorithm>
#include <cmath>

#include "scenes/city/blocks/block_kinds.h"

namespace cps::city {
namespace {

BuildingPlan row_house(BlockSite& site, const Footprint& footprint, int base_storeys, int spread) {
  BuildingPlan b;
  b.footprint = footprint;
  b.storeys = std::clamp(base_storeys + site.draws.integer(-spread, spread), 2, 8);
  b.shops = site.draws.chance(site.character.shop_share);
  const bool flat = site.draws.chance(site.character.flat_roof_share);
  b.roof = flat || b.storeys > 6                     ? RoofKind::flat
           : b.storeys > 3 && site.draws.chance(0.4) ? RoofKind::mansard
                                                     : RoofKind::gable;
  return b;
}

void add_rear_wing(BlockSite& site) {
  BuildingPlan b = site.plan.buildings.back();
  b.rear_wing_m = site.draws.chance(0.25) ? site.draws.uniform(4, 7) : 0;
  if (const Polygon wing = rear_wing(b); wing.empty() || !is_free(site, wing)) return;
  site.plan.buildings.back() = b;
}

void fill_row(BlockSite& site, const Polyline& line, double from, double to, double depth, int storeys) {
  Draws& draws = site.draws;
  if (to - from < 6) return;
  const int lots = std::max(1, static_cast<int>(std::lround((to - from) / draws.uniform(11, 17))));
  std::vector<double> cuts(lots + 1);
  for (int k = 0; k <= lots; ++k)
    cuts[k] = from + (to - from) * (k + (k > 0 && k < lots ? draws.uniform(-0.25, 0.25) : 0.0)) / lots;
  Polyline front(lots + 1);
  for (int k = 0; k <= lots; ++k) front[k] = station_at(line, cuts[k]).point;
  const Footprint row = make_footprint(front, depth);
  for (int k = 0; k < lots; ++k) {
    if (draws.chance(0.04)) continue;  // a gap: the entrance to the court
    // Neighbours share the row's mitred corners, so that their party walls coincide.
    const Footprint lot{{front[k], front[k + 1]}, {row.inward[k], row.inward[k + 1]}, depth};
    if (signed_area(lot.polygon()) > 30 && try_building(site, row_house(site, lot, storeys, 1)))
      add_rear_wing(site);
  }
}

/// Marks the ends of houses that adjoin another house: party walls have no windows.
void find_party_walls(BlockPlan& plan) {
  constexpr double gap_m = 0.3;
  for (BuildingPlan& b : plan.buildings)
    for (const bool at_end : {false, true}) {
      const Footprint& f = b.footprint;
      const std::size_t i = at_end ? f.front.size() - 1 : 0;
      const Vec2 out = (at_end ? f.front[i] - f.front[i - 1] : f.front[0] - f.front[1]).normalized();
      const Vec2 beyond = f.at(i, f.depth_m / 2) + out * gap_m;
      (at_end ? b.party_end : b.party_start) =
          std::any_of(plan.buildings.begin(), plan.buildings.end(),
                      [&](const BuildingPlan& other) { return contains(other.footprint.polygon(), beyond); });
    }
}

}  // namespace

void fill_closed_block(BlockSite& site) {
  Draws& draws = site.draws;
  const std::vector<Frontage>& sides = site.sides;
  site.plan.ground = GroundKind::paving;
  const int storeys = draw_storeys(site, 2, 7);
  const double depth = draws.uniform(10, 13);
  std::vector<double> start(sides.size(), 0), end(sides.size(), 0);  // lengths taken by corner houses
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!sides[i].corner_at_end) continue;
    const std::size_t next = (i + 1) % sides.size();
    const double before = length(sides[i].line), after = length(sides[next].line);
    const Vec2 in = station_at(sides[i].line, before).direction,
               out = station_at(sides[next].line, 0).direction;
    const double turn = std::atan2(cross(in, out), in.dot(out));
    const double arm = depth * std::tan(std::max(0.0, turn) / 2) + draws.uniform(3, 7);
    if (turn < 0.7 || turn > 2.2 || arm > before * 0.48 || arm > after * 0.48) continue;
    const Footprint corner = make_footprint({station_at(sides[i].line, before - arm).point,
                                             sides[i].line.back(), station_at(sides[next].line, arm).point},
                                            depth);
    if (try_building(site, row_house(site, corner, storeys, 2))) end[i] = start[next] = arm;
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    fill_row(site, sides[i].line, start[i], length(sides[i].line) - end[i], depth, storeys);
  find_party_walls(site.plan);
  plant(site, 11 / site.character.tree_density, 3);
}

}  // namespace cps::city
