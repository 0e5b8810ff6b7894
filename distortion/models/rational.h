#pragma once

#include "distortion/models/projected_ray.h"

namespace cps {

/// OpenCV's rational model, ideal → distorted on the plane z = 1: the radial factor is
/// (1 + k1 s + k2 s² + k3 s³) / (1 + k4 s + k5 s² + k6 s³) with s = r²; tangential terms as in Brown–Conrady.
struct RationalLens {
  double k1 = 0, k2 = 0, k3 = 0, k4 = 0, k5 = 0, k6 = 0, p1 = 0, p2 = 0;
  bool operator==(const RationalLens&) const = default;
};

/// Where the lens sends one ideal point, and the Jacobian there, which is symmetric as Brown–Conrady's is:
/// the radial part is the gradient of a function of r². Unchecked: the denominator is not 0.
[[gnu::always_inline]] inline DistortedPoint evaluate(const RationalLens& lens, double x, double y) {
  const double s = x * x + y * y;
  const double numerator = 1 + s * (lens.k1 + s * (lens.k2 + s * lens.k3));
  const double inverse = 1 / (1 + s * (lens.k4 + s * (lens.k5 + s * lens.k6)));
  const double factor = numerator * inverse;
  const double numerator_slope = lens.k1 + s * (2 * lens.k2 + s * 3 * lens.k3);
  const double denominator_slope = lens.k4 + s * (2 * lens.k5 + s * 3 * lens.k6);
  const double slope = 2 * (numerator_slope - factor * denominator_slope) * inverse;  // 2 dR/ds
  const double diagonal = factor + 2 * (lens.p2 * x + lens.p1 * y);
  return {.x = x * diagonal + lens.p2 * s,
          .y = y * diagonal + lens.p1 * s,
          .xx = diagonal + x * (slope * x + 4 * lens.p2),
          .xy = slope * x * y + 2 * (lens.p2 * y + lens.p1 * x),
          .yy = diagonal + y * (slope * y + 4 * lens.p1)};
}

/// Distorted point of an ideal point, both on the plane z = 1.
inline Eigen::Vector2d distort(const RationalLens& lens, const Eigen::Vector2d& ideal) {
  const DistortedPoint at = evaluate(lens, ideal.x(), ideal.y());
  return {at.x, at.y};
}

/// Jacobian ∂distorted/∂ideal.
inline Eigen::Matrix2d distortion_jacobian(const RationalLens& lens, const Eigen::Vector2d& ideal) {
  const DistortedPoint at = evaluate(lens, ideal.x(), ideal.y());
  Eigen::Matrix2d jacobian;
  jacobian << at.xx, at.xy, at.xy, at.yy;
  return jacobian;
}

/// projection.h.
[[gnu::always_inline]] inline ProjectedRay project(const RationalLens& lens, const Eigen::Vector3d& ray) {
  const ProjectedRay on_plane = divided(ray, ray.z(), {0, 0, 1});
  return composed(evaluate(lens, on_plane.point.x(), on_plane.point.y()), on_plane);
}

}  // namespace cps
