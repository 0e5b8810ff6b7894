#pragma once

#include <cmath>

#include "distortion/models/projected_ray.h"

namespace cps {

/// Enhanced unified camera model (Khomutenko, Garcia, Martinet 2016): a ray (x, y, z) lands at
/// (x, y) / (α √(β (x² + y²) + z²) + (1 − α) z).
struct Eucm {
  double alpha = 0;  ///< in [0, 1]
  double beta = 1;   ///< > 0
  bool operator==(const Eucm&) const = default;
};

/// projection.h.
[[gnu::always_inline]] inline ProjectedRay project(const Eucm& lens, const Eigen::Vector3d& ray) {
  const double x = ray.x(), y = ray.y(), z = ray.z();
  const double root = std::sqrt(lens.beta * (x * x + y * y) + z * z), slope = lens.alpha / root;
  return divided(ray, lens.alpha * root + (1 - lens.alpha) * z,
                 {slope * lens.beta * x, slope * lens.beta * y, slope * z + 1 - lens.alpha});
}

}  // namespace cps
