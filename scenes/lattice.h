#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

namespace cps {

/// Direction `i` of `count` that are spread evenly over the part of the unit sphere above y = `lowest`: a
/// Fibonacci lattice (González 2010).
inline Eigen::Vector3d lattice_direction(int i, int count, double lowest) {
  const double y = 1 - (1 - lowest) * (i + 0.5) / count, radius = std::sqrt(1 - y * y);
  const double turn = 2 * std::numbers::pi * std::fmod(i * (std::numbers::phi - 1), 1.0);
  return {radius * std::cos(turn), y, radius * std::sin(turn)};
}

/// Directions spread evenly over the sphere, made once.
template <std::size_t count>
const std::array<Eigen::Vector3f, count>& sphere_directions() {
  static const auto directions = [] {
    std::array<Eigen::Vector3f, count> unit;
    for (std::size_t i = 0; i < count; ++i)
      unit[i] = lattice_direction(static_cast<int>(i), count, -1).cast<float>();
    return unit;
  }();
  return directions;
}

}  // namespace cps
