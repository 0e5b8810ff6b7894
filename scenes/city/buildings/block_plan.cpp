#include "scenes/city/buildings/block_plan.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/buildings/frontage.h"

namespace cps::city {
namespace {

class BlockPlanner {
 public:
  BlockPlanner(BlockPlan& plan, const CityCharacter& character, Draws& draws)
      : plan(plan), character(character), draws(draws), border(without_repeats(plan.border.points)) {
    base_storeys =
        std::clamp(static_cast<int>(std::lround(character.mean_storeys + draws.uniform(-1.5, 1.5))), 2, 7);
  }

  /// Houses wall to wall along all streets, L-shaped at the corners.
  void fill_closed(const std::vector<Frontage>& sides) {
    const double depth = draws.uniform(10, 13);
    std::vector<double> start(sides.size(), 0), end(sides.size(), 0);  // taken by corner houses
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
      if (try_building(corner, 2)) end[i] = start[next] = arm;
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
      fill_row(sides[i].line, start[i], length(sides[i].line) - end[i], depth);
    find_party_walls();
  }

  /// An end of a house that another one stands against has no windows.
  void find_party_walls() {
    constexpr double gap_m = 0.3;
    for (BuildingPlan& b : plan.buildings)
      for (const bool at_end : {false, true}) {
        const Footprint& f = b.footprint;
        const std::size_t i = at_end ? f.front.size() - 1 : 0;
        const Vec2 out = (at_end ? f.front[i] - f.front[i - 1] : f.front[0] - f.front[1]).normalized();
        const Vec2 beyond = f.at(i, f.depth_m / 2) + out * gap_m;
        (at_end ? b.party_end : b.party_start) = std::any_of(
            plan.buildings.begin(), plan.buildings.end(),
            [&](const BuildingPlan& other) { return contains(other.footprint.polygon(), beyond); });
      }
  }

  /// Houses apart from each other behind front gardens.
  void fill_detached(const std::vector<Frontage>& sides) {
    const double setback = draws.uniform(2.5, 6);
    const bool hedged = draws.chance(0.6);
    for (const Frontage& side : sides) {
      const double total = length(side.line);
      double s = draws.uniform(2, 6);
      while (s < total - 10) {
        const double width = draws.uniform(8.5, 15), depth = draws.uniform(8.5, 12);
        if (s + width > total - 2) break;
        const Polyline front{station_at(side.line, s).point, station_at(side.line, s + width).point};
        const Polyline line = offset(front, setback + draws.uniform(0, 1.5));
        try_building(make_footprint(line, depth), 1);
        s += width + draws.uniform(3.5, 8);
      }
      if (hedged && total > 8) plan.hedges.push_back(offset(cut(side.line, 0.8, total - 0.8), 0.7));
    }
  }

  /// Long blocks of flats on grass.
  void fill_slabs(const std::vector<Frontage>& sides) {
    const double setback = draws.uniform(4, 9);
    base_storeys = std::clamp(base_storeys + 2, 4, 8);
    for (const Frontage& side : sides) {
      const double total = length(side.line);
      double s = setback + draws.uniform(0, 6);
      while (s < total - setback - 14) {
        const double width = std::min(draws.uniform(18, 42), total - setback - s),
                     depth = draws.uniform(11, 14);
        const Polyline front{station_at(side.line, s).point, station_at(side.line, s + width).point};
        try_building(make_footprint(offset(front, setback), depth), 1);
        s += width + draws.uniform(8, 16);
      }
    }
  }

  /// Trees wherever nothing is built, about `spacing` metres apart.
  void plant(double spacing, double from_border) {
    Vec2 low = border[0], high = border[0];
    for (const Vec2& p : border) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (double x = low.x(); x < high.x(); x += spacing)
      for (double y = low.y(); y < high.y(); y += spacing) {
        const Vec2 p(x + draws.uniform(0, 0.8) * spacing, y + draws.uniform(0, 0.8) * spacing);
        const bool wanted = draws.chance(0.75);
        if (wanted && contains(border, p) && is_free(p, 4.0) && border_distance(p) > from_border)
          plan.trees.push_back(p);
      }
  }

 private:
  double border_distance(const Vec2& p) const {
    Polyline closed = border;
    closed.push_back(closed.front());
    return distance_to_line(closed, p);
  }

  bool is_free(const Vec2& p, double clearance) const {
    return std::none_of(plan.buildings.begin(), plan.buildings.end(), [&](const BuildingPlan& b) {
      const Polygon wing = rear_wing(b);
      return distance_to_polygon(b.footprint.polygon(), p) < clearance ||
             (!wing.empty() && distance_to_polygon(wing, p) < clearance);
    });
  }

  bool is_free(const Polygon& polygon) const {
    for (const Vec2& p : polygon)
      if (!contains(border, p) && border_distance(p) > 0.05) return false;
    return std::none_of(plan.buildings.begin(), plan.buildings.end(), [&](const BuildingPlan& b) {
      const Polygon wing = rear_wing(b);
      return overlap(polygon, b.footprint.polygon()) || (!wing.empty() && overlap(polygon, wing));
    });
  }

  /// Plans a house if its ground is free; `spread`: how far its height may differ from the block's.
  bool try_building(const Footprint& footprint, int spread) {
    const double roof = draws.uniform(0, 1);
    BuildingPlan b;
    b.footprint = footprint;
    b.storeys = std::clamp(base_storeys + draws.integer(-spread, spread), 2, 8);
    b.detached = plan.kind != BlockKind::closed;
    b.shops = plan.kind == BlockKind::closed && draws.chance(character.shop_share);
    if (roof < character.flat_roof_share || b.storeys > 6 || plan.kind == BlockKind::slabs)
      b.roof = RoofKind::flat;
    else if (b.detached)
      b.roof = draws.chance(0.4) ? RoofKind::hip : RoofKind::gable;
    else
      b.roof = b.storeys > 3 && draws.chance(0.4) ? RoofKind::mansard : RoofKind::gable;
    if (b.detached && plan.kind == BlockKind::detached) b.storeys = std::min(b.storeys, draws.integer(2, 3));
    if (signed_area(footprint.polygon()) < 30 || !is_free(footprint.polygon())) return false;
    plan.buildings.push_back(b);
    return true;
  }

  void fill_row(const Polyline& line, double from, double to, double depth) {
    if (to - from < 6) return;
    const int lots = std::max(1, static_cast<int>(std::lround((to - from) / draws.uniform(11, 17))));
    std::vector<double> cuts(lots + 1);
    for (int k = 0; k <= lots; ++k)
      cuts[k] = from + (to - from) * (k + (k > 0 && k < lots ? draws.uniform(-0.25, 0.25) : 0.0)) / lots;
    Polyline front(lots + 1);
    for (int k = 0; k <= lots; ++k) front[k] = station_at(line, cuts[k]).point;
    const Footprint row = make_footprint(front, depth);
    for (int k = 0; k < lots; ++k) {
      if (draws.chance(0.04)) continue;  // a gap: the way into the court
      // Neighbours share the row's mitred corners, so that their party walls coincide.
      const Footprint lot{{front[k], front[k + 1]}, {row.inward[k], row.inward[k + 1]}, depth};
      if (!try_building(lot, 1)) continue;
      BuildingPlan& b = plan.buildings.back();
      b.rear_wing_m = draws.chance(0.25) ? draws.uniform(4, 7) : 0;
      if (!rear_wing(b).empty()) {
        const BuildingPlan candidate = b;
        plan.buildings.pop_back();
        const bool fits = is_free(rear_wing(candidate));
        plan.buildings.push_back(candidate);
        if (!fits) plan.buildings.back().rear_wing_m = 0;
      }
    }
  }

  BlockPlan& plan;
  const CityCharacter& character;
  Draws& draws;
  Polygon border;
  int base_storeys = 3;
};

BlockKind draw_kind(const CityCharacter& c, bool at_rim, Draws& draws) {
  const double park = at_rim ? 0 : c.park;
  double x = draws.uniform(0, c.closed + c.detached + c.slabs + park);
  if ((x -= c.closed) < 0) return BlockKind::closed;
  if ((x -= c.detached) < 0) return BlockKind::detached;
  if ((x -= c.slabs) < 0) return BlockKind::slabs;
  return BlockKind::park;
}

}  // namespace

CityCharacter draw_character(std::uint64_t seed) {
  Draws draws{make_stream(seed, "character")};
  CityCharacter c;
  c.closed = draws.uniform(0.6, 2.0);
  c.detached = draws.uniform(0.1, 1.5);
  c.slabs = draws.uniform(0.0, 0.6);
  c.park = draws.uniform(0.05, 0.3);
  c.mean_storeys = draws.uniform(2.4, 5.1);
  c.shop_share = draws.uniform(0.1, 0.5);
  c.flat_roof_share = draws.uniform(0.05, 0.6);
  c.tree_density = draws.uniform(0.4, 1.5);
  return c;
}

BlockPlan plan_block(const StreetNetwork& network, int index, const CityCharacter& character,
                     std::uint64_t seed) {
  const Block& block = network.blocks[index];
  Draws draws{substream(make_stream(seed, "block"), index)};
  BlockPlan plan;
  plan.kind = draw_kind(character, block.at_rim, draws);
  double widest = 0;
  for (const Side& side : block.sides) {
    plan.pavement_m.push_back(network.is_road(side) ? network.profile(side).pavement_m : 0);
    widest = std::max(widest, plan.pavement_m.back());
  }
  plan.border = outline(network, block, plan.pavement_m, widest);
  BlockPlanner planner(plan, character, draws);
  const std::vector<Frontage> sides = frontages(network, block, plan.border);
  switch (plan.kind) {
    case BlockKind::closed:
      planner.fill_closed(sides);
      planner.plant(11 / character.tree_density, 3);
      break;
    case BlockKind::detached:
      planner.fill_detached(sides);
      planner.plant(9 / character.tree_density, 2);
      break;
    case BlockKind::slabs:
      planner.fill_slabs(sides);
      planner.plant(10 / character.tree_density, 2.5);
      break;
    case BlockKind::park:
      planner.plant(8, 2.5);
      break;
  }
  return plan;
}

}  // namespace cps::city
