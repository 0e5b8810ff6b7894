#pragma once

#include <cmath>

#include "distortion/models/projected_ray.h"

namespace cps {

/// Double sphere model (Usenko, Demmel, Cremers 2018): with d = |ray| and d' = √(x² + y² + (ξ d + z)²), a ray
/// (x, y, z) lands at (x, y) / (α d' + (1 − α)(ξ d + z)).
struct DoubleSphere {
  double xi = 0;     ///< in (−1, 1]
  double alpha = 0;  ///< in [0, 1]
  bool operator==(const DoubleSphere&) const = default;
};

/// projection.h.
[[gnu::always_inline]] inline ProjectedRay project(const DoubleSphere& lens, const Eigen::Vector3d& ray) {
  const double x = ray.x(), y = ray.y(), z = ray.z(), across2 = x * x + y * y;
  const double first = std::sqrt(across2 + z * z), along = ahead_of_centre(lens.xi, across2, z, first);
  const double second = std::sqrt(across2 + along * along);
  // With ∂first = ray / first, ∂along = ξ ∂first + (0, 0, 1), ∂second = ((x, y, 0) + along ∂along) / second.
  const double alpha = lens.alpha / second, along_slope = alpha * along + 1 - lens.alpha;
  const double common = lens.xi / first * along_slope;
  return divided(ray, lens.alpha * second + (1 - lens.alpha) * along,
                 {(common + alpha) * x, (common + alpha) * y, common * z + along_slope});
}

}  // namespace cps
