#include "scenes/wheels.h"

#include <array>
#include <cmath>

namespace cps {
namespace {

constexpr double wheelbase_m = 2.7, track_m = 1.55;
constexpr double reach_m = 0.6;
constexpr float cos_max_slope = 0.8192f;  // 35°

std::optional<double> ground_height(const SceneRays& rays, const Eigen::Vector3d& near) {
  const Eigen::Vector3d from = near + Eigen::Vector3d(0, reach_m, 0);
  const auto hit = first_hit(rays, from.cast<float>(), {0, -1, 0});
  if (!hit || hit->distance_m > 2 * reach_m || std::abs(hit->normal.y()) < cos_max_slope) return std::nullopt;
  return from.y() - hit->distance_m;
}

}  // namespace

Place on_wheels(const SceneRays& rays, const Place& place) {
  const Eigen::Isometry3d world_from_vehicle = cps::world_from_vehicle(place);
  std::array<double, 4> height;  // rear right, rear left, front right, front left
  for (int wheel = 0; wheel < 4; ++wheel) {
    const Eigen::Vector3d at(wheel & 2 ? wheelbase_m : 0, (wheel & 1 ? 0.5 : -0.5) * track_m, 0);
    const std::optional<double> ground = ground_height(rays, world_from_vehicle * at);
    if (!ground) return place;
    height[wheel] = *ground;
  }
  const auto [rear_right, rear_left, front_right, front_left] = height;
  Place standing = place;
  standing.position.y() = (rear_right + rear_left) / 2;
  standing.pitch_rad = std::atan((front_right + front_left - rear_right - rear_left) / 2 / wheelbase_m);
  standing.roll_rad = std::atan((rear_left + front_left - rear_right - front_right) / 2 / track_m);
  return standing;
}

}  // namespace cps
