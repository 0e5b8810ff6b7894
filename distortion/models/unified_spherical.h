#pragma once

#include <cmath>

#include "distortion/models/projected_ray.h"

namespace cps {

/// Unified spherical model (Geyer and Daniilidis 2000; Mei and Rives 2007): a unit ray (x, y, z) lands at
/// (x, y) / (z + ξ), and goes through a Brown–Conrady lens from there. ξ = 0 is Brown–Conrady itself. The
/// focal length is Mei's γ: a ray near the axis moves by γ / (1 + ξ) per radian.
struct UnifiedSpherical {
  double xi = 0;               ///< ≥ 0
  Distortion distortion = {};  ///< on the plane of (x, y) / (z + ξ)
  bool operator==(const UnifiedSpherical&) const = default;
};

/// Where the sphere alone sends a ray: on the plane of (x, y) / (z + ξ).
[[gnu::always_inline]] inline ProjectedRay project_by_sphere(double xi, const Eigen::Vector3d& ray) {
  const double x = ray.x(), y = ray.y(), z = ray.z(), across2 = x * x + y * y;
  const double length = std::sqrt(across2 + z * z), slope = xi / length;
  return divided(ray, ahead_of_centre(xi, across2, z, length), {slope * x, slope * y, slope * z + 1});
}

/// projection.h.
[[gnu::always_inline]] inline ProjectedRay project(const UnifiedSpherical& lens, const Eigen::Vector3d& ray) {
  const ProjectedRay on_plane = project_by_sphere(lens.xi, ray);
  return composed(evaluate(lens.distortion, on_plane.point.x(), on_plane.point.y()), on_plane);
}

}  // namespace cps
