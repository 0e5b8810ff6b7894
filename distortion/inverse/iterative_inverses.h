#pragma once

#include <Eigen/Core>

#include "distortion/brown_conrady.h"

/// The iterations by which other programs invert a lens, each starting at the distorted point. None of them
/// detects whether it converges, or to which root. They are here to report how they do on a given lens; the
/// inverse that this project uses is undistort().
namespace cps {

/// x ← x + (distorted − D(x)).
Eigen::Vector2d undistort_by_fixed_point(const Distortion& lens, const Eigen::Vector2d& distorted, int steps);

/// x ← (distorted − tangential(x)) / radial(x), as OpenCV's undistortPoints does (5 steps by default). Like
/// OpenCV it returns the distorted point if the radial factor becomes negative.
Eigen::Vector2d undistort_by_ratio(const Distortion& lens, const Eigen::Vector2d& distorted, int steps);

/// x ← x − J(x)⁻¹ (D(x) − distorted), without a line search.
Eigen::Vector2d undistort_by_newton(const Distortion& lens, const Eigen::Vector2d& distorted, int steps);

}  // namespace cps
