#include "distortion/certificate/displacement.h"

#include "distortion/certificate/branch_and_bound.h"
#include "distortion/certificate/polar_lens.h"

namespace cps {

double largest_displacement(const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  const PolarLens polar = polar_lens(lens, rectangle);

  // In the radial/tangential frame D(x) − x = ((R−1) r + 3 |q| r² c, |q| r² √(1−c²)). Its squared length is
  // convex in c, so it is largest at an end of the range of c.
  const auto largest = [](double radial, double tangential, Interval cosines) {
    const auto squared = [&](double c) {
      const double along = radial + 3 * tangential * c;
      return along * along + tangential * tangential * std::max(0.0, 1 - c * c);
    };
    return std::sqrt(std::max(squared(cosines.low), squared(cosines.high)));
  };
  const auto on_ring = [&](double r) {
    const double radial = (polar.radial(r * r) - 1) * r, tangential = polar.tangential * r * r;
    return smallest_on_ring(polar, r, [&](Interval c) { return -largest(radial, tangential, c); });
  };
  // Along a ray D(x) − x is a convex combination of the vectors formed by its Bernstein coefficients, and the
  // length of a vector is convex: the longest of those vectors is a bound.
  const auto on_cell = [&](double r0, double r1, double) {
    const Form<1> r{r0, r1};
    const Form<2> s = r * r;
    const Form<4> s2 = s * s;
    const RadialCubic& R = polar.radial;
    const Form<6> excess =
        sum(sum(sum(Form<6>{}, R.b, s * binomials<4>), R.c, s2 * binomials<2>), R.d, s2 * s);
    const Form<7> radial = excess * r, tangential = s * binomials<5>;
    return smallest_on_ring(polar, r0, [&](Interval c) {
      double bound = 0;
      for (int i = 0; i <= 7; ++i)
        bound = std::max(bound, largest(radial[i] / binomials<7>[i],
                                        polar.tangential * tangential[i] / binomials<7>[i], c));
      return -bound;
    });
  };
  const EnclosedMinimum negative = smallest_value(0, 1, {}, on_cell, on_ring);
  return (-negative.proved + polar.rounding) * polar.unit / (0.5 * rectangle.diagonal().norm());
}

}  // namespace cps
