#include <algorithm>

#include "scenes/city/blocks/block_kinds.h"

namespace cps::city {
namespace {

/// A lot, measured in its frame. `side`: the garage is on the left (−1) or on the right (1).
struct Lot {
  LotFrame frame;
  double width = 18, depth = 26, setback = 5;
  double side = 1;

  /// The frame's u of a distance from the garage's side of the lot.
  double u(double from_garage_side) const { return side * (width / 2 - from_garage_side); }
  Polygon rectangle(double near, double far, double v0, double v1) const {
    return frame.rectangle(std::min(u(near), u(far)), std::max(u(near), u(far)), v0, v1);
  }
  Footprint footprint(double near, double far, double v0, double v1) const {
    return frame.footprint(std::min(u(near), u(far)), std::max(u(near), u(far)), v0, v1);
  }
};

RoofKind draw_roof(BlockSite& site) {
  if (site.draws.chance(site.character.flat_roof_share)) return RoofKind::flat;
  return site.draws.chance(0.35) ? RoofKind::hip : RoofKind::gable;
}

/// Adds boundaries along the street, with gaps for the driveway and the path, and along one side of the lot.
void enclose(BlockSite& site, const Lot& lot, double drive_end, double path) {
  constexpr double inset_m = 0.45, gate_m = 1.3;
  const double pick = site.draws.uniform(0, 1);
  if (pick > 0.86) return;
  const BoundaryKind kind = pick < 0.40   ? BoundaryKind::hedge
                            : pick < 0.55 ? BoundaryKind::picket_fence
                            : pick < 0.68 ? BoundaryKind::mesh_fence
                                          : BoundaryKind::low_wall;
  const auto add = [&](BoundaryKind what, const Vec2& from, const Vec2& to) {
    if ((to - from).norm() > 0.8) site.plan.boundaries.push_back({what, {from, to}});
  };
  const auto along_street = [&](double near, double far) {
    add(kind, lot.frame.at(lot.u(near), inset_m), lot.frame.at(lot.u(far), inset_m));
  };
  along_street(drive_end + 0.2, path - gate_m / 2);
  along_street(path + gate_m / 2, lot.width);
  if (site.draws.chance(0.7))
    add(site.draws.chance(0.5) ? BoundaryKind::hedge : BoundaryKind::mesh_fence,
        lot.frame.at(lot.u(lot.width), inset_m + 0.8), lot.frame.at(lot.u(lot.width), lot.depth - 1));
}

bool build_lot(BlockSite& site, const Lot& lot) {
  Draws& draws = site.draws;
  const bool garage = draws.chance(0.75);
  const double garage_width = lot.width > 20 && draws.chance(0.3) ? 6.0 : 3.3;
  const double drive_end = 0.5 + garage_width;
  const double house_start = drive_end + (draws.chance(0.5) ? 0.0 : draws.uniform(0.8, 1.6));
  const double house_width =
      std::min(draws.uniform(8.5, 13.5), lot.width - house_start - draws.uniform(2.0, 3.5));
  const double house_depth = std::min(draws.uniform(8.5, 11.5), lot.depth - lot.setback - 3);
  if (house_width < 7 || house_depth < 7) return false;

  BuildingPlan house;
  house.footprint =
      lot.footprint(house_start, house_start + house_width, lot.setback, lot.setback + house_depth);
  house.storeys = std::clamp(draw_storeys(site, 1, 3), 1, 3);
  house.detached = true;
  house.roof = draw_roof(site);
  house.gable_to_street = house.roof == RoofKind::gable && draws.chance(0.4);
  if (!try_building(site, house)) return false;

  const double garage_front = lot.setback + draws.uniform(0.8, 3.5);
  if (garage) {
    BuildingPlan shed;
    shed.kind = BuildingKind::garage;
    shed.footprint = lot.footprint(0.5, drive_end, garage_front, garage_front + 6.2);
    shed.storeys = 1;
    shed.roof = draws.chance(0.6) ? RoofKind::flat : RoofKind::gable;
    shed.gable_to_street = shed.roof == RoofKind::gable;
    try_building(site, shed);
  }
  const GroundKind surface = draws.chance(0.6) ? GroundKind::paving : GroundKind::concrete;
  if (try_pad(site, {surface, lot.rectangle(0.5, drive_end, 0, garage_front)}) && draws.chance(0.55) &&
      garage_front > 5.2) {
    const Vec2 in = left_of(lot.frame.along);
    site.plan.car_spots.push_back({lot.frame.at(lot.u(0.5 + 1.65), garage_front - 2.9),
                                   draws.chance(0.6) ? in : Vec2(-in), pad_rise_m});
  }
  const double path = house_start + house_width * draws.uniform(0.3, 0.7);
  try_pad(site, {surface, lot.rectangle(path - 0.6, path + 0.6, 0, lot.setback - 1.2)});
  try_pad(site,
          {surface, lot.rectangle(house_start, house_start + house_width, lot.setback - 1.2, lot.setback)});
  enclose(site, lot, drive_end, path);
  return true;
}

}  // namespace

void fill_detached_block(BlockSite& site) {
  Draws& draws = site.draws;
  const double setback = draws.uniform(3.5, 7);
  std::vector<Polygon> taken;
  for (const Frontage& side : site.sides) {
    const double total = length(side.line);
    double s = draws.uniform(0.5, 2);
    while (s + 15 < total) {
      Lot lot;
      lot.width = std::min(draws.uniform(15, 24), total - s);
      lot.setback = setback + draws.uniform(0, 1.5);
      lot.side = draws.chance(0.5) ? 1 : -1;
      lot.frame = lot_frame(side.line, s, lot.width);
      bool built = false;
      for (const double depth : {27.0, 22.0, 18.0}) {
        lot.depth = depth;
        const Polygon ground = lot.frame.rectangle(-lot.width / 2, lot.width / 2, 0.3, depth);
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const Polygon& p) { return overlap(ground, p, 0.3); }) ||
            !is_free(site, ground))
          continue;
        built = build_lot(site, lot);
        if (built) taken.push_back(ground);
        break;
      }
      s += built ? lot.width : 3;
    }
  }
  plant(site, 9 / site.character.tree_density, 2);
}

}  // namespace cps::city
