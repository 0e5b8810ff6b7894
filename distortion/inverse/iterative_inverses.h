#pragma once

#include <Eigen/Core>

#include "distortion/brown_conrady.h"

/// The iterations by which other programs invert a lens, each from the distorted point itself. None of them
/// knows whether it converges, or to which root; here to tell a user what to expect of them. undistort() is
/// ours.
namespace cps {

/// x ← x + (distorted − D(x)).
Eigen::Vector2d undistort_by_fixed_point(const Distortion& lens, const Eigen::Vector2d& distorted, int steps);

/// x ← (distorted − tangential(x)) / radial(x), as OpenCV's undistortPoints does (5 steps unless told
/// otherwise), which returns the distorted point where the radial factor becomes negative.
Eigen::Vector2d undistort_by_ratio(const Distortion& lens, const Eigen::Vector2d& distorted, int steps);

/// x ← x − J(x)⁻¹ (D(x) − distorted), every step taken whole.
Eigen::Vector2d undistort_by_newton(const Distortion& lens, const Eigen::Vector2d& distorted, int steps);

}  // namespace cps
