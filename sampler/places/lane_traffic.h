#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scene.h"

namespace cps {

/// What stands on a scene's lanes, as points on their centre lines (world, at most half a metre apart).
struct LaneTraffic {
  std::vector<Eigen::Vector3d> points;
};

LaneTraffic traffic_on(std::span<const Lane> lanes);

/// Whether a car (4.8 m long, its rear axle at the place) has 1 m of free road behind it, 4 m before it, and
/// nothing on its own width in between.
bool is_clear_of(const LaneTraffic& traffic, const Place& place);

}  // namespace cps
