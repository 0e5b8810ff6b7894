#include "scenes/drive/surroundings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace cps {
namespace {

constexpr int directions = 16;

double turn_rad(int direction) {
  return 2 * std::numbers::pi * direction / directions;
}

}  // namespace

double Surroundings::share() const {
  return static_cast<double>(std::popcount(seen)) / directions;
}

double Surroundings::on_both_sides(double heading_rad) const {
  constexpr double min_sine = 0.9;  // 64° to 116° to the side
  int in[2] = {0, 0}, things[2] = {0, 0};
  for (int i = 0; i < directions; ++i) {
    const double sine = std::sin(-turn_rad(i) - heading_rad);  // headings grow the other way in x and z
    if (std::abs(sine) < min_sine) continue;
    const int side = sine > 0 ? 0 : 1;
    ++in[side];
    things[side] += seen >> i & 1;
  }
  return std::min(static_cast<double>(things[0]) / in[0], static_cast<double>(things[1]) / in[1]);
}

double Surroundings::ahead(double heading_rad) const {
  constexpr double min_cosine = 0.64;
  int in = 0, things = 0;
  for (int i = 0; i < directions; ++i) {
    if (std::cos(-turn_rad(i) - heading_rad) < min_cosine) continue;
    ++in;
    things += seen >> i & 1;
  }
  return static_cast<double>(things) / in;
}

Surroundings look_around(const SceneRays& rays, const Eigen::Vector3f& ground) {
  constexpr double reach_m = 40, rise_rad = 0.05;  // a little upwards, over bumps of the ground
  constexpr float eye_m = 1.65f, max_slope_cosine = 0.7f;
  Surroundings around;
  for (int i = 0; i < directions; ++i) {
    const Eigen::Vector3d direction(std::cos(rise_rad) * std::cos(turn_rad(i)), std::sin(rise_rad),
                                    std::cos(rise_rad) * std::sin(turn_rad(i)));
    const auto hit = first_hit(rays, ground + Eigen::Vector3f(0, eye_m, 0), direction.cast<float>());
    if (hit && hit->distance_m < reach_m && std::abs(hit->normal.y()) < max_slope_cosine)
      around.seen |= static_cast<std::uint16_t>(1 << i);
  }
  return around;
}

}  // namespace cps
