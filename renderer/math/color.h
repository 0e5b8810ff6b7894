#pragma once

#include <Eigen/Core>

namespace cps {

using Vec3 = Eigen::Vector3f;

/// Linear Rec. 709, componentwise arithmetic. Radiance is in kcd/m² (Y of white = 1 is 1000 cd/m²),
/// irradiance in klx.
using Color = Eigen::Array3f;

/// Y of a linear Rec. 709 colour.
inline float luminance(const Color& c) {
  return 0.2126f * c.x() + 0.7152f * c.y() + 0.0722f * c.z();
}

}  // namespace cps
