#pragma once

#include <span>

#include "random/counter_hash.h"
#include "scenes/scene.h"

namespace cps {

/// How a car stands off its lane: to the left of the centre line, and turned to the left of its direction.
struct LaneOffset {
  double lateral_m = 0, yaw_rad = 0;
  LaneOffset& operator+=(const LaneOffset& other);
};

/// Under way from lane `lane`, `distance_m` along it, to one that runs beside it in the same direction and
/// street, at a drawn moment of a change that takes 40 m of road; no offset where there is no such lane.
LaneOffset draw_lane_change(std::span<const Lane> lanes, int lane, double distance_m, Stream stream);

}  // namespace cps
