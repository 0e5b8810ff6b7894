#pragma once

#include <Eigen/Core>

namespace cps {

/// Brown–Conrady coefficients, running ideal → distorted with OpenCV's order and signs
/// (Brown 1966; Conrady 1919). k1 < 0 is barrel, k1 > 0 pincushion. All zero: no distortion.
struct Distortion {
  double k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0;
  bool operator==(const Distortion&) const = default;
};

/// Where the lens sends one ideal point, and the Jacobian ∂distorted/∂ideal there. The Jacobian is symmetric,
/// because the map is the gradient of Φ = r²/2 + k1 r⁴/4 + k2 r⁶/6 + k3 r⁸/8 + (p2 x + p1 y) r².
struct DistortedPoint {
  double x, y;
  double xx, xy, yy;  ///< of the Jacobian
};

/// The Brown–Conrady model, on the plane z = 1 (x right, y down):
/// x_d = x(1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2x²), y_d likewise with p1 and p2 swapped.
///
/// The only evaluation of the model: distort() and distortion_jacobian() call it for one point, and loops
/// over rows of points call it directly. It has no branch and is always inlined, so such a loop compiles to
/// vector instructions and what it does not use of the result costs nothing.
[[gnu::always_inline]] inline DistortedPoint evaluate(const Distortion& lens, double x, double y) {
  const double s = x * x + y * y;
  const double diagonal = 1 + s * (lens.k1 + s * (lens.k2 + s * lens.k3)) + 2 * (lens.p2 * x + lens.p1 * y);
  const double slope = 2 * (lens.k1 + s * (2 * lens.k2 + s * 3 * lens.k3));  // 2 dR/ds
  return {.x = x * diagonal + lens.p2 * s,
          .y = y * diagonal + lens.p1 * s,
          .xx = diagonal + x * (slope * x + 4 * lens.p2),
          .xy = slope * x * y + 2 * (lens.p2 * y + lens.p1 * x),
          .yy = diagonal + y * (slope * y + 4 * lens.p1)};
}

/// Distorted point of an ideal point, both on the plane z = 1.
inline Eigen::Vector2d distort(const Distortion& lens, const Eigen::Vector2d& ideal) {
  const DistortedPoint at = evaluate(lens, ideal.x(), ideal.y());
  return {at.x, at.y};
}

/// Jacobian ∂distorted/∂ideal.
inline Eigen::Matrix2d distortion_jacobian(const Distortion& lens, const Eigen::Vector2d& ideal) {
  const DistortedPoint at = evaluate(lens, ideal.x(), ideal.y());
  Eigen::Matrix2d jacobian;
  jacobian << at.xx, at.xy, at.xy, at.yy;
  return jacobian;
}

/// The same lens in coordinates divided by `unit`: k_i · unit^(2i), p_i · unit. With the half diagonal of the
/// frame as the unit, coefficients mean the same at every field of view; 1/unit undoes it.
inline Distortion rescaled(const Distortion& lens, double unit) {
  const double s = unit * unit;
  return {lens.k1 * s, lens.k2 * s * s, lens.k3 * s * s * s, lens.p1 * unit, lens.p2 * unit};
}

}  // namespace cps
