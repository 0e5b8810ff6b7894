#include "sampler/places/lane_traffic.h"

#include <algorithm>
#include <cmath>

#include "scenes/routes.h"

namespace cps {
namespace {

/// Distances of the bumpers from the rear axle (VW Passat, KITTI's car), and the free road behind and ahead.
constexpr double rear_bumper_m = 1.1, front_bumper_m = 3.7, free_behind_m = 1, free_ahead_m = 4;
/// Half the widths of two cars, and their lateral deviations; the neighbouring lane's centre line is 3 m
/// away.
constexpr double abreast_m = 2.2;
constexpr double other_level_m = 3;
constexpr double step_m = 0.5, max_steps = 1000;

}  // namespace

LaneTraffic traffic_on(std::span<const Lane> lanes) {
  LaneTraffic traffic;
  for (const Lane& lane : lanes)
    for (const LaneStretch& stretch : lane.occupied) {
      const double from = std::max(stretch.from_m, 0.0), to = std::min(stretch.to_m, length_m(lane));
      const int steps = static_cast<int>(std::clamp((to - from) / step_m, 0.0, max_steps)) + 1;
      for (int i = 0; i <= steps && from < to; ++i)
        traffic.points.push_back(place_on_lane(lane, std::lerp(from, to, i / double(steps)), 0, 0).position);
    }
  return traffic;
}

bool is_clear_of(const LaneTraffic& traffic, const Place& place) {
  const Eigen::Isometry3d vehicle_from_world = world_from_vehicle(place).inverse();
  return std::none_of(traffic.points.begin(), traffic.points.end(), [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d at = vehicle_from_world * point;
    return at.x() > -rear_bumper_m - free_behind_m && at.x() < front_bumper_m + free_ahead_m &&
           std::abs(at.y()) < abreast_m && std::abs(at.z()) < other_level_m;
  });
}

}  // namespace cps
