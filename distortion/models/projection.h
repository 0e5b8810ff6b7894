#pragma once

#include "distortion/models/lens_model.h"
#include "distortion/models/projected_ray.h"

/// Each family's file has its project(lens, ray), always inlined, for loops over pixels: visit the variant
/// outside the loop.
///
/// It projects a ray (camera frame: x right, y down, z forward) of any positive length that can be squared;
/// the point depends on its direction only, so jacobian · ray = 0. Unchecked: the ray's angle from the axis
/// is below angle_limit().
namespace cps {

/// Brown–Conrady, as described above.
[[gnu::always_inline]] inline ProjectedRay project(const Distortion& lens, const Eigen::Vector3d& ray) {
  const ProjectedRay on_plane = divided(ray, ray.z(), {0, 0, 1});
  return composed(evaluate(lens, on_plane.point.x(), on_plane.point.y()), on_plane);
}

/// Any family, as described above.
ProjectedRay project(const LensModel& lens, const Eigen::Vector3d& ray);

/// The angle from the axis, radians, below which the family's formula is defined and grows with the angle,
/// its polynomial coefficients left aside: π/2 for the families of the plane (brown_conrady, rational); π for
/// kannala_brandt; arccos(−ξ) or, for ξ > 1, arccos(−1/ξ) for unified_spherical; for eucm and double_sphere
/// the angle where the radius stops growing or becomes infinite, in closed form. Unchecked: the lens'
/// parameters are within their range.
double angle_limit(const LensModel& lens);

}  // namespace cps
