#include "scenes/city/buildings/building.h"

namespace cps::city {

Building building(const BuildingPlan& plan, const Materials& materials, Stream stream) {
  switch (plan.kind) {
    case BuildingKind::house:
      return house(plan, materials, stream);
    case BuildingKind::tower:
      return tower(plan, materials, stream);
    case BuildingKind::hall:
      return hall(plan, materials, stream);
    case BuildingKind::garage:
      return garage(plan, materials, stream);
  }
  return {};
}

Polygon rear_wing(const BuildingPlan& plan) {
  if (plan.rear_wing_m <= 0 || plan.footprint.front.size() != 2) return {};
  const Polyline back = plan.footprint.line_at(plan.footprint.depth_m);
  const Vec2 along = (back[1] - back[0]).normalized(), in = left_of(along) * plan.rear_wing_m;
  const double l = (back[1] - back[0]).norm();
  const Vec2 a = back[0] + along * (0.05 * l), b = back[0] + along * (0.5 * l);
  return {a, b, b + in, a + in};
}

}  // namespace cps::city
