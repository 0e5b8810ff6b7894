#pragma once

#include <Eigen/Core>

#include "numbers/luminance.h"

namespace cps {

using Vec3 = Eigen::Vector3f;

/// Linear Rec. 709, componentwise arithmetic. Radiance is in kcd/m² (Y of white = 1 is 1000 cd/m²),
/// irradiance in klx.
using Color = Eigen::Array3f;

/// Y of a linear Rec. 709 colour.
inline float luminance(const Color& c) {
  return luminance(c.x(), c.y(), c.z());
}

}  // namespace cps
