#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "random/counter_hash.h"

namespace cps {

/// (p1, p2) at a uniform angle, with a length uniform in [0, largest].
inline Eigen::Vector2d draw_tangential(double largest, Stream stream) {
  const double angle = random_uniform(stream, 0, 0, 2 * std::numbers::pi);
  const double length = random_uniform(stream, 1, 0, largest);
  return {length * std::sin(angle), length * std::cos(angle)};
}

}  // namespace cps
