#include "distortion/certificate/rim_gauge.h"

#include <algorithm>

#include "distortion/certificate/bernstein.h"
#include "distortion/certificate/rim_search.h"
#include "numbers/interval.h"

namespace cps {
namespace {

/// Encloses a polynomial on [0, 1] by its Bernstein coefficients, widened by their rounding error.
Interval range(const Form<7>& form) {
  double low = form[0], high = form[0], size = 0;
  for (int i = 0; i < 8; ++i) {
    const double coefficient = form[i] / binomials<7>[i];
    low = std::min(low, coefficient);
    high = std::max(high, coefficient);
    size = std::max(size, std::abs(coefficient));
  }
  return {low - 1e-14 * size, high + 1e-14 * size};
}

/// The image of a segment parallel to the u axis, u from u0 to u1 with v fixed, as two polynomials. (u, v) is
/// (x, y) or (y, x), and (pu, pv) is (p2, p1) or (p1, p2) accordingly.
struct DistortedSegment {
  Form<7> u, v;
};
DistortedSegment distorted_segment(const Distortion& lens, double pu, double pv, double u0, double u1,
                                   double v) {
  const Form<1> along{u0, u1};
  const Form<2> along_squared = along * along;
  const Form<2> s = sum(along_squared, v * v, binomials<2>);
  const Form<4> s2 = s * s;
  const Form<6> s3 = s2 * s;
  const Form<6> radial =
      sum(sum(sum(binomials<6>, lens.k1, s * binomials<4>), lens.k2, s2 * binomials<2>), lens.k3, s3);
  const Form<2> u_tangential =
      sum(sum(Form<2>{}, pu, sum(s, 2, along_squared)), 2 * pv * v, along * Form<1>{1, 1});
  const Form<2> v_tangential =
      sum(sum(Form<2>{}, pv, sum(s, 2 * v * v, binomials<2>)), 2 * pu * v, along * Form<1>{1, 1});
  return {sum(along * radial, 1, u_tangential * binomials<5>),
          sum(sum(Form<7>{}, v, Form<1>{1, 1} * radial), 1, v_tangential * binomials<5>)};
}

}  // namespace

double smallest_rim_gauge(const Distortion& lens, const Eigen::AlignedBox2d& rectangle,
                          const Eigen::AlignedBox2d& frame) {
  const auto image = [&](const Eigen::Vector2d& point) { return distort(lens, point); };
  const auto enclosure = [&](const SideSegment& side) -> std::array<Interval, 2> {
    const double pu = side.is_horizontal ? lens.p2 : lens.p1, pv = side.is_horizontal ? lens.p1 : lens.p2;
    const DistortedSegment segment = distorted_segment(lens, pu, pv, side.low, side.high, side.fixed);
    return {range(side.is_horizontal ? segment.u : segment.v),
            range(side.is_horizontal ? segment.v : segment.u)};
  };
  return smallest_gauge_of_rim(rectangle, frame, image, enclosure);
}

}  // namespace cps
