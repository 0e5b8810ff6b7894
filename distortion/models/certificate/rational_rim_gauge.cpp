#include <algorithm>
#include <array>
#include <cmath>

#include "distortion/certificate/bernstein.h"
#include "distortion/certificate/rim_search.h"
#include "distortion/models/certificate/rational_certificate.h"
#include "numbers/infinity.h"

namespace cps {
namespace {

/// Encloses a quotient on [0, 1] by the quotients of its Bernstein coefficients, if the denominator's are
/// above `rounding` times its terms' size; `n_size` and `d_size` bound the terms of both.
Interval range(const Form<8>& numerator, const Form<8>& denominator, double n_size, double d_size) {
  constexpr double rounding = 1e-14;
  double low = infinity, high = -infinity, least = infinity;
  for (int i = 0; i <= 8; ++i) {
    const double quotient = numerator[i] / denominator[i];
    low = std::min(low, quotient);
    high = std::max(high, quotient);
    least = std::min(least, denominator[i] / binomials<8>[i]);
  }
  const double margin = rounding * (n_size + std::max(std::abs(low), std::abs(high)) * d_size) / least;
  if (!(least > rounding * d_size && std::isfinite(margin))) return {-infinity, infinity};
  return {low - margin, high + margin};
}

/// 1 + k1 s + k2 s² + k3 s³.
Form<6> cubic(double k1, double k2, double k3, const Form<2>& s) {
  return sum(sum(sum(binomials<6>, k1, s * binomials<4>), k2, s * s * binomials<2>), k3, s * s * s);
}

}  // namespace

double smallest_rim_gauge(const RationalLens& lens, const Eigen::AlignedBox2d& rectangle,
                          const Eigen::AlignedBox2d& frame) {
  const auto image = [&](const Eigen::Vector2d& point) {
    const DistortedPoint at = evaluate(lens, point.x(), point.y());
    return Eigen::Vector2d(at.x, at.y);
  };
  // u runs along the side and v is fixed; (pu, pv) is (p2, p1) or (p1, p2) accordingly.
  const auto enclosure = [&](const SideSegment& side) -> std::array<Interval, 2> {
    const double pu = side.is_horizontal ? lens.p2 : lens.p1, pv = side.is_horizontal ? lens.p1 : lens.p2;
    const double v = side.fixed, reach = std::max({std::abs(side.low), std::abs(side.high), std::abs(v)});
    const Form<1> along{side.low, side.high};
    const Form<2> along_squared = along * along, s = sum(along_squared, v * v, binomials<2>);
    const Form<6> N = cubic(lens.k1, lens.k2, lens.k3, s), D = cubic(lens.k4, lens.k5, lens.k6, s);
    const Form<2> u_tangential =
        sum(sum(Form<2>{}, pu, sum(s, 2, along_squared)), 2 * pv * v, along * Form<1>{1, 1});
    const Form<2> v_tangential =
        sum(sum(Form<2>{}, pv, sum(s, 2 * v * v, binomials<2>)), 2 * pu * v, along * Form<1>{1, 1});
    const Form<8> denominator = D * binomials<2>, u = sum(along * N * Form<1>{1, 1}, 1, u_tangential * D),
                  v_image = sum(sum(Form<8>{}, v, N * binomials<2>), 1, v_tangential * D);
    const double farthest = std::max(s[0], s[2]);
    const auto size = [&](double k1, double k2, double k3) {
      return 1 + farthest * (std::abs(k1) + farthest * (std::abs(k2) + farthest * std::abs(k3)));
    };
    const double d_size = size(lens.k4, lens.k5, lens.k6);
    const double n_size = reach * size(lens.k1, lens.k2, lens.k3) +
                          6 * farthest * (std::abs(lens.p1) + std::abs(lens.p2)) * d_size;
    const Interval u_range = range(u, denominator, n_size, d_size),
                   v_range = range(v_image, denominator, n_size, d_size);
    return {side.is_horizontal ? u_range : v_range, side.is_horizontal ? v_range : u_range};
  };
  return smallest_gauge_of_rim(rectangle, frame, image, enclosure);
}

}  // namespace cps
