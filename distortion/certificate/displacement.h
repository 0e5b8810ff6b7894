#pragma once

#include <Eigen/Geometry>

#include "distortion/brown_conrady.h"

namespace cps {

/// Upper bound, tight to 1e-5, on how far the lens moves any point of the rectangle, as a fraction of the
/// rectangle's half diagonal. Rectangle as for certify(); lens and rectangle must be finite.
double largest_displacement(const Distortion& lens, const Eigen::AlignedBox2d& rectangle);

}  // namespace cps
