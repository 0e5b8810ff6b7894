#pragma once

#include <Eigen/Core>

namespace cps {

/// Brown–Conrady coefficients, running ideal → distorted with OpenCV's order and signs
/// (Brown 1966; Conrady 1919). k1 < 0 is barrel, k1 > 0 pincushion. All zero: no distortion.
struct Distortion {
  double k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0;
  bool operator==(const Distortion&) const = default;
};

/// Distorted point of an ideal point, both on the plane z = 1 (x right, y down):
/// x_d = x(1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2x²), y_d likewise with p1 and p2 swapped.
Eigen::Vector2d distort(const Distortion& lens, const Eigen::Vector2d& ideal);

/// Jacobian ∂distorted/∂ideal. Symmetric, because the map is the gradient of
/// Φ = r²/2 + k1 r⁴/4 + k2 r⁶/6 + k3 r⁸/8 + (p2 x + p1 y) r².
Eigen::Matrix2d distortion_jacobian(const Distortion& lens, const Eigen::Vector2d& ideal);

}  // namespace cps
