#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/brown_conrady.h"

namespace cps {

/// The ideal point of `box` that the lens sends to `distorted`; empty: proved to lie outside D(box). The lens
/// is certified on the box, which makes Φ(x) − distorted·x strictly convex there: its minimiser over the box,
/// found by Newton steps that minimise the quadratic model over the box exactly, is the answer where the
/// gradient vanishes, and where it does not, there is none. A wrong root does not exist. Not checked: on a
/// lens that folds inside the box the answer, if any, is one of several.
///
/// Residual |D(x) − distorted| at rounding level; a target outside by less than 1e-12 of its size counts as
/// inside.
std::optional<Eigen::Vector2d> undistort(const Distortion& lens, const Eigen::AlignedBox2d& box,
                                         const Eigen::Vector2d& distorted);

/// The same from a guess: the ray of a neighbouring point of the image, for example. A few Newton steps, and
/// undistort() where they do not arrive inside the box.
std::optional<Eigen::Vector2d> undistort_near(const Distortion& lens, const Eigen::AlignedBox2d& box,
                                              const Eigen::Vector2d& distorted, const Eigen::Vector2d& guess);

}  // namespace cps
