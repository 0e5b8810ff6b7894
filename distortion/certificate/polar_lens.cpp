#include "distortion/certificate/polar_lens.h"

namespace cps {

PolarLens polar_lens(const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  const Eigen::Vector2d low = rectangle.min().cwiseMin(0.0), high = rectangle.max().cwiseMax(0.0);
  PolarLens polar;
  polar.unit = low.cwiseAbs().cwiseMax(high).norm();

  const auto [k1, k2, k3, p1, p2] = rescaled(lens, polar.unit);
  polar.radial = {k1, k2, k3};
  polar.radial_slope = {3 * k1, 5 * k2, 7 * k3};
  const Eigen::Vector2d q(p2, p1);
  polar.tangential = q.norm();
  // Covers a few dozen roundings of terms no larger than the coefficients, and the rounding of the cosines.
  constexpr double unit_roundoff = 0x1p-53;
  polar.rounding =
      64 * unit_roundoff * (1 + 7 * (std::abs(k1) + std::abs(k2) + std::abs(k3)) + 8 * polar.tangential) +
      1e-13;

  const Eigen::Vector2d pull =
      polar.tangential > 0 ? Eigen::Vector2d(q / polar.tangential) : Eigen::Vector2d(1, 0);
  for (int i = 0; i < 4; ++i) {
    const double sign_x = i & 1 ? -1 : 1, sign_y = i & 2 ? -1 : 1;
    const double x = (sign_x > 0 ? high.x() : -low.x()) / polar.unit;
    const double y = (sign_y > 0 ? high.y() : -low.y()) / polar.unit;
    if (x > 0 && y > 0) polar.quadrants[i] = {x, y, std::hypot(x, y), {sign_x * pull.x(), sign_y * pull.y()}};
  }
  return polar;
}

}  // namespace cps
