#pragma once

#include <span>

#include "random/counter_hash.h"
#include "scenes/scene.h"

namespace cps {

/// Pose of a car relative to its lane: offset to the left of the centre line, turn to the left of its
/// direction.
struct LaneOffset {
  double lateral_m = 0, yaw_rad = 0;
  LaneOffset& operator+=(const LaneOffset& other);
};

/// The offset of a car that is changing from lane `lane`, `distance_m` along it, to a lane beside it in the
/// same street and direction, at a random moment of a change that takes 40 m of road. No offset if there is
/// no such lane.
LaneOffset draw_lane_change(std::span<const Lane> lanes, int lane, double distance_m, Stream stream);

}  // namespace cps
