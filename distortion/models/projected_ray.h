#pragma once

#include <Eigen/Core>

#include "distortion/brown_conrady.h"

namespace cps {

/// Where a lens sends a ray in the normalised image ((pixel − principal point) / focal length), and how that
/// moves with the ray.
struct ProjectedRay {
  Eigen::Vector2d point;
  Eigen::Matrix<double, 2, 3> jacobian;  ///< ∂point/∂ray
};

/// The ray (x, y, z) at (x, y) / D, where D is a function of the ray with this gradient.
[[gnu::always_inline]] inline ProjectedRay divided(const Eigen::Vector3d& ray, double denominator,
                                                   const Eigen::Vector3d& gradient) {
  const double scale = 1 / denominator, x = scale * ray.x(), y = scale * ray.y();
  const double gx = scale * gradient.x(), gy = scale * gradient.y(), gz = scale * gradient.z();
  ProjectedRay result;
  result.point << x, y;
  result.jacobian << scale - x * gx, -x * gy, -x * gz, -y * gx, scale - y * gy, -y * gz;
  return result;
}

/// A ray's point on a plane, sent on by a lens of that plane: `at` is the lens evaluated at on_plane.point.
[[gnu::always_inline]] inline ProjectedRay composed(const DistortedPoint& at, const ProjectedRay& on_plane) {
  ProjectedRay result;
  result.point << at.x, at.y;
  result.jacobian.row(0) = at.xx * on_plane.jacobian.row(0) + at.xy * on_plane.jacobian.row(1);
  result.jacobian.row(1) = at.xy * on_plane.jacobian.row(0) + at.yy * on_plane.jacobian.row(1);
  return result;
}

/// ξ |ray| + z: how far a point of a sphere about the origin lies ahead of (0, 0, −ξ |ray|). No digits are
/// lost near the direction of −z for ξ about 1.
[[gnu::always_inline]] inline double ahead_of_centre(double xi, double across2, double z, double length) {
  return z >= 0 ? xi * length + z : (xi - 1) * length + across2 / (length - z);
}

/// ∂ray/∂point for rays of constant length: the pseudo-inverse of the Jacobian, whose rows are orthogonal to
/// the ray. Unchecked: the Jacobian has rank 2.
[[gnu::always_inline]] inline Eigen::Matrix<double, 3, 2> ray_jacobian(
    const Eigen::Matrix<double, 2, 3>& jacobian) {
  const double xx = jacobian.row(0).squaredNorm(), yy = jacobian.row(1).squaredNorm();
  const double xy = jacobian.row(0).dot(jacobian.row(1));
  const double scale = 1 / (xx * yy - xy * xy);
  Eigen::Matrix<double, 3, 2> result;
  result.col(0) = scale * (yy * jacobian.row(0) - xy * jacobian.row(1)).transpose();
  result.col(1) = scale * (xx * jacobian.row(1) - xy * jacobian.row(0)).transpose();
  return result;
}

}  // namespace cps
