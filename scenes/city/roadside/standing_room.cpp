#include "scenes/city/roadside/standing_room.h"

#include <algorithm>

namespace cps::city {

bool StandingRoom::try_place(const PlacedModel& model) {
  const Polygon ground = model.footprint();
  const auto hits = [&](const Polygon& other) { return overlap(ground, other, 0); };
  for (const PlacedModel& p : placed)
    if ((p.position - model.position).norm() < 8 && hits(p.footprint())) return false;
  for (const BuildingPlan& b : plan.buildings) {
    const Polygon wing = rear_wing(b);
    if (hits(b.footprint.polygon()) || (!wing.empty() && hits(wing))) return false;
  }
  if (std::any_of(kept_free.begin(), kept_free.end(), hits)) return false;
  placed.push_back(model);
  return true;
}

}  // namespace cps::city
