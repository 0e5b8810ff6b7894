#pragma once

#include <Eigen/Geometry>

#include "distortion/brown_conrady.h"

namespace cps {

/// How far the lens moves a point of the rectangle at most, as a fraction of the rectangle's half diagonal:
/// an upper bound, tight to 1e-5. Rectangle as for certify(); lens and rectangle must be finite.
double largest_displacement(const Distortion& lens, const Eigen::AlignedBox2d& rectangle);

}  // namespace cps
