#pragma once

#include <algorithm>
#include <cmath>

#include "numbers/interval.h"

/// The Jacobian of a lens of the plane on a ring about the principal point (polar_lens.h).
namespace cps {

inline constexpr Interval every_cosine{-1, 1};

/// Smallest eigenvalue of [[g + 6ac, 2a√(1−c²)], [·, R + 2ac]] over a range of c. It is
/// (g+R)/2 + 4ac − ½√((g−R)² + 16a² + 8(g−R)ac): the root of an affine function of c, so convex in c,
/// smallest at an end or where its derivative vanishes, √… = (g−R)/2. The largest eigenvalue is minus the
/// smallest of −J, which has the same form with the signs of g, R and c reversed.
inline double smallest_eigenvalue(double g, double R, double a, Interval c) {
  const double d = g - R;
  const auto at = [&](double cosine) {
    return 0.5 * (g + R) + 4 * a * cosine -
           0.5 * std::sqrt(std::max(0.0, d * d + 16 * a * a + 8 * d * a * cosine));
  };
  double smallest = std::min(at(c.low), at(c.high));
  if (d > 0 && a > 0) {
    const double stationary = -(0.75 * d * d + 16 * a * a) / (8 * d * a);
    if (c.low < stationary && stationary < c.high) smallest = std::min(smallest, at(stationary));
  }
  return smallest;
}

/// An end of the eigenvalues' range.
enum class End { smallest, largest };

}  // namespace cps
