#include "scenes/city/blocks/block_site.h"

#include <algorithm>
#include <cmath>

namespace cps::city {
namespace {

double border_distance(const BlockSite& site, const Vec2& p) {
  Polyline closed = site.border;
  closed.push_back(closed.front());
  return distance_to_line(closed, p);
}

bool is_plantable(const BlockSite& site, const Vec2& p, double clearance_m) {
  const auto near = [&](const Polygon& polygon, double distance_m) {
    return !polygon.empty() && distance_to_polygon(polygon, p) < distance_m;
  };
  return std::none_of(site.plan.buildings.begin(), site.plan.buildings.end(),
                      [&](const BuildingPlan& b) {
                        return near(b.footprint.polygon(), clearance_m) || near(rear_wing(b), clearance_m);
                      }) &&
         std::none_of(site.plan.pads.begin(), site.plan.pads.end(),
                      [&](const Pad& pad) { return near(pad.outline, 0.8); });
}

}  // namespace

LotFrame lot_frame(const Polyline& front, double s, double width_m) {
  const Vec2 from = station_at(front, s).point, to = station_at(front, s + width_m).point;
  return {(from + to) / 2, (to - from).normalized()};
}

bool is_free(const BlockSite& site, const Polygon& ground, double slack_m) {
  for (const Vec2& p : ground)
    if (!contains(site.border, p) && border_distance(site, p) > slack_m) return false;
  return std::none_of(site.plan.buildings.begin(), site.plan.buildings.end(),
                      [&](const BuildingPlan& b) {
                        const Polygon wing = rear_wing(b);
                        return overlap(ground, b.footprint.polygon()) ||
                               (!wing.empty() && overlap(ground, wing));
                      }) &&
         std::none_of(site.plan.pads.begin(), site.plan.pads.end(),
                      [&](const Pad& pad) { return overlap(ground, pad.outline); });
}

bool try_building(BlockSite& site, const BuildingPlan& building) {
  const Polygon ground = building.footprint.polygon();
  if (signed_area(ground) < 12 || !is_free(site, ground)) return false;
  site.plan.buildings.push_back(building);
  return true;
}

bool try_pad(BlockSite& site, const Pad& pad) {
  if (!is_free(site, pad.outline, 0.3)) return false;
  site.plan.pads.push_back(pad);
  return true;
}

int draw_storeys(BlockSite& site, int lowest, int highest) {
  return std::clamp(
      static_cast<int>(std::lround(site.character.mean_storeys + site.draws.uniform(-1.5, 1.5))), lowest,
      highest);
}

void plant(BlockSite& site, double spacing_m, double from_border_m) {
  Vec2 low = site.border[0], high = site.border[0];
  for (const Vec2& p : site.border) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (double x = low.x(); x < high.x(); x += spacing_m)
    for (double y = low.y(); y < high.y(); y += spacing_m) {
      const double dx = site.draws.uniform(0, 0.8), dy = site.draws.uniform(0, 0.8);
      const Vec2 p(x + dx * spacing_m, y + dy * spacing_m);
      const bool wanted = site.draws.chance(0.75);
      if (wanted && contains(site.border, p) && is_plantable(site, p, 4.0) &&
          border_distance(site, p) > from_border_m)
        site.plan.trees.push_back(p);
    }
}

}  // namespace cps::city
