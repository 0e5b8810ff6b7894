#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/brown_conrady.h"

namespace cps {

/// The ideal point in `box` that the lens sends to `distorted`; empty if that point provably lies outside
/// D(box). The lens must be certified on the box (not checked; if it folds there, the answer is one of
/// several). Then Φ(x) − distorted·x, with Φ from brown_conrady.h, is strictly convex on the box. Newton
/// steps that minimise its quadratic model over the box exactly find its only minimiser: the answer if the
/// gradient vanishes there, and a proof that there is no answer if it does not.
///
/// The residual |D(x) − distorted| is at rounding level. A target outside D(box) by less than 1e-12 of its
/// size, or than four roundings of the ideal point move its image, counts as inside.
std::optional<Eigen::Vector2d> undistort(const Distortion& lens, const Eigen::AlignedBox2d& box,
                                         const Eigen::Vector2d& distorted);

/// As undistort(), but starting at `guess`, for example the ideal point of a neighbouring pixel: a few Newton
/// steps, and undistort() if they do not converge inside the box.
std::optional<Eigen::Vector2d> undistort_near(const Distortion& lens, const Eigen::AlignedBox2d& box,
                                              const Eigen::Vector2d& distorted, const Eigen::Vector2d& guess);

}  // namespace cps
