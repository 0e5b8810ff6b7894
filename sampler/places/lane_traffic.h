#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scene.h"

namespace cps {

/// The occupied stretches of a scene's lanes, as points on their centre lines (world, at most half a metre
/// apart).
struct LaneTraffic {
  std::vector<Eigen::Vector3d> points;
};

LaneTraffic traffic_on(std::span<const Lane> lanes);

/// Whether a car (4.8 m long, its rear axle at the place) stands free of the traffic: nothing on its width
/// from 1 m behind it to 4 m ahead of it.
bool is_clear_of(const LaneTraffic& traffic, const Place& place);

}  // namespace cps
