#include <algorithm>

#include "scenes/city/blocks/block_kinds.h"

namespace cps::city {
namespace {

constexpr double fence_inset_m = 0.5, gate_m = 7;

BuildingPlan draw_hall(Draws& draws) {
  BuildingPlan hall;
  hall.kind = BuildingKind::hall;
  hall.detached = true;
  hall.storeys = 1;
  const double roof = draws.uniform(0, 1);
  hall.roof = roof < 0.45 ? RoofKind::flat : roof < 0.75 ? RoofKind::gable : RoofKind::sawtooth;
  return hall;
}

/// Adds an office building of a few storeys in front of a hall.
void add_office(BlockSite& site, const LotFrame& frame, double half_width, double setback) {
  Draws& draws = site.draws;
  const double width = draws.uniform(9, 16), depth = std::min(draws.uniform(6, 9), setback - 2);
  if (depth < 5 || width > half_width) return;
  const double u = draws.chance(0.5) ? -half_width : half_width - width;
  BuildingPlan office;
  office.footprint = frame.footprint(u, u + width, setback - depth, setback);
  office.storeys = draws.integer(1, 3);
  office.detached = true;
  office.roof = RoofKind::flat;
  try_building(site, office);
}

/// Adds spots for cars side by side behind the fence.
void add_car_park(BlockSite& site, const LotFrame& frame, double from_u, double to_u) {
  const Vec2 in = left_of(frame.along);
  for (double u = from_u; u + 2.6 < to_u; u += 2.6)
    if (site.draws.chance(0.7) && is_free(site, frame.rectangle(u, u + 2.5, 1.4, 6.6)))
      site.plan.car_spots.push_back({frame.at(u + 1.25, 4.0), site.draws.chance(0.7) ? Vec2(-in) : in});
}

void add_goods(BlockSite& site) {
  Vec2 low = site.border[0], high = site.border[0];
  for (const Vec2& p : site.border) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const int wanted = site.draws.integer(4, 16);
  for (int i = 0; i < wanted * 3 && static_cast<int>(site.plan.goods_spots.size()) < wanted; ++i) {
    const double x = site.draws.uniform(low.x(), high.x()), y = site.draws.uniform(low.y(), high.y());
    const Vec2 along = site.sides.empty() ? Vec2(1, 0) : station_at(site.sides[0].line, 0).direction;
    const LotFrame frame{{x, y}, along};
    if (is_free(site, frame.rectangle(-6, 6, -5, 5), 0))
      site.plan.goods_spots.push_back({frame.origin, along});
  }
}

/// Adds the fence along a frontage, with gaps at the gates.
void add_fence(BlockSite& site, const Frontage& side, BoundaryKind kind, const std::vector<double>& gates) {
  const double total = length(side.line);
  double s = fence_inset_m;
  const auto add = [&](double to) {
    if (to - s > 1) site.plan.boundaries.push_back({kind, offset(cut(side.line, s, to), fence_inset_m)});
  };
  for (double gate : gates) {
    add(gate - gate_m / 2);
    s = gate + gate_m / 2;
  }
  add(total - fence_inset_m);
}

}  // namespace

void fill_hall_block(BlockSite& site) {
  Draws& draws = site.draws;
  site.plan.ground = draws.chance(0.55) ? GroundKind::concrete : GroundKind::asphalt;
  const double pick = draws.uniform(0, 1);
  const BoundaryKind fence = pick < 0.5    ? BoundaryKind::mesh_fence
                             : pick < 0.75 ? BoundaryKind::high_wall
                                           : BoundaryKind::hedge;
  const bool fenced = draws.chance(0.8);
  for (const Frontage& side : site.sides) {
    const double total = length(side.line), setback = draws.uniform(5, 14);
    std::vector<double> gates;
    double s = draws.uniform(4, 10);
    while (s < total - 22) {
      const double width = std::min(draws.uniform(22, 58), total - s - 4);
      const LotFrame frame = lot_frame(side.line, s, width);
      BuildingPlan hall = draw_hall(draws);
      bool built = false;
      for (double depth = draws.uniform(20, 40); !built && depth > 14; depth *= 0.75) {
        hall.footprint = frame.footprint(-width / 2, width / 2, setback, setback + depth);
        built = width > 16 && try_building(site, hall);
      }
      if (built) {
        gates.push_back(s + width * draws.uniform(0.3, 0.7));
        if (draws.chance(0.4)) add_office(site, frame, width / 2, setback);
        if (draws.chance(0.5)) add_car_park(site, frame, -width / 2 + gate_m, width / 2);
      }
      s += built ? width + draws.uniform(6, 16) : 5;
    }
    if (fenced) add_fence(site, side, fence, gates);
  }
  add_goods(site);
  plant(site, 14 / site.character.tree_density, 1.5);
}

}  // namespace cps::city
