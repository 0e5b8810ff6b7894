#include "distortion/displacement.h"

#include "distortion/branch_and_bound.h"
#include "distortion/polar_lens.h"

namespace cps {

double largest_displacement(const Distortion& lens, const Eigen::AlignedBox2d& rectangle) {
  const PolarLens polar = polar_lens(lens, rectangle);
  const RadialCubic& R = polar.radial;
  const RadialCubic excess{0, R.b, R.c, R.d};  // R − 1

  // |D(x) − x| = r·√((R−1 + 3ac)² + a²(1−c²)): convex in c, in R−1 and in a, so largest at the ends of their
  // ranges.
  const auto relative = [](double excess, double a, double c) {
    const double radial = excess + 3 * a * c;
    return std::sqrt(radial * radial + a * a * std::max(0.0, 1 - c * c));
  };
  const auto on_ring = [&](double r) {
    const double e = excess(r * r), a = polar.tangential * r;
    return smallest_on_ring(
        polar, r, [&](Interval c) { return -r * std::max(relative(e, a, c.low), relative(e, a, c.high)); });
  };
  const auto on_cell = [&](double r0, double r1) {
    const Interval e = excess.range(r0 * r0, r1 * r1);
    return smallest_on_ring(polar, r0, [&](Interval c) {
      double largest = 0;
      for (const double a : {polar.tangential * r0, polar.tangential * r1})
        for (const double cosine : {c.low, c.high})
          largest = std::max({largest, relative(e.low, a, cosine), relative(e.high, a, cosine)});
      return -r1 * largest;
    });
  };
  const EnclosedMinimum negative = smallest_value(0, 1, {}, on_cell, on_ring);
  return (-negative.proved + polar.rounding) * polar.unit / (0.5 * rectangle.diagonal().norm());
}

}  // namespace cps
