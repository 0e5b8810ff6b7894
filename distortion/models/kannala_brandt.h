#pragma once

#include <algorithm>
#include <cmath>

#include "distortion/models/projected_ray.h"
#include "distortion/models/straight_angle.h"

namespace cps {

/// Kannala and Brandt (2006), as in OpenCV's fisheye module: a ray at the angle θ from the axis lands at the
/// radius θ + k1 θ³ + k2 θ⁵ + k3 θ⁷ + k4 θ⁹ of the normalised image.
struct KannalaBrandt {
  double k1 = 0, k2 = 0, k3 = 0, k4 = 0;
  bool operator==(const KannalaBrandt&) const = default;
};

/// The radius r of the normalised image at an angle θ.
struct FisheyeRadius {
  double per_angle;  ///< r / θ
  double slope;      ///< dr / dθ
};

[[gnu::always_inline]] inline FisheyeRadius evaluate(const KannalaBrandt& lens, double angle_rad) {
  const double s = angle_rad * angle_rad;
  return {.per_angle = 1 + s * (lens.k1 + s * (lens.k2 + s * (lens.k3 + s * lens.k4))),
          .slope = 1 + s * (3 * lens.k1 + s * (5 * lens.k2 + s * (7 * lens.k3 + s * (9 * lens.k4))))};
}

/// projection.h.
[[gnu::always_inline]] inline ProjectedRay project(const KannalaBrandt& lens, const Eigen::Vector3d& ray) {
  const double x = ray.x(), y = ray.y(), z = ray.z(), across2 = x * x + y * y, length2 = across2 + z * z;
  const AxisAngle at = angle_from_axis(std::sqrt(across2), z);
  const auto [per_angle, slope] = evaluate(lens, at.angle_rad);
  // The map stretches by `scale` around the axis and by slope · z / |ray|² away from it.
  const double scale = at.per_across * per_angle, along = slope / length2;
  const double stretch = (along * z - scale) / std::max(across2, 1e-290);  // 0 on the axis
  ProjectedRay result;
  result.point << scale * x, scale * y;
  result.jacobian << scale + stretch * x * x, stretch * x * y, -along * x, stretch * x * y,
      scale + stretch * y * y, -along * y;
  return result;
}

}  // namespace cps
