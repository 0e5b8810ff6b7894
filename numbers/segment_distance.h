#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace cps {

/// Distance of a point of the plane from the segment from a to b, which may be a point.
template <typename Number>
Number distance_to_segment(const Eigen::Matrix<Number, 2, 1>& a, const Eigen::Matrix<Number, 2, 1>& b,
                           const Eigen::Matrix<Number, 2, 1>& point) {
  const Eigen::Matrix<Number, 2, 1> ab = b - a;
  const Number t =
      std::clamp((point - a).dot(ab) / std::max(ab.squaredNorm(), Number(1e-12)), Number(0), Number(1));
  return (a + ab * t - point).norm();
}

}  // namespace cps
