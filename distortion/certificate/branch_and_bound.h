#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace cps {

/// The smallest value of a function on an interval, enclosed: proved ≤ minimum ≤ attained = f(argument).
struct EnclosedMinimum {
  double proved = std::numeric_limits<double>::infinity();
  double attained = std::numeric_limits<double>::infinity();
  double argument = 0;
};

/// When a branch-and-bound search may stop.
struct MinimumSearch {
  double tolerance = 1e-5;  ///< between `proved` and `attained`; infinite: only the threshold matters
  /// The search goes on while the minimum could lie on either side of this value. With an infinite tolerance
  /// it stops at the first attained value below it.
  double threshold = -std::numeric_limits<double>::infinity();
  int max_halvings = 1024;  ///< of intervals in all
};

/// Smallest value on [low, high] by branch and bound. `lower_bound(a, b, enough)` bounds the function from
/// below on [a, b]; it may return the first bound it finds that is at least `enough`. `value(x)` evaluates
/// the function. Depth and number of halvings are limited: if the bounds do not converge by then, `proved` is
/// looser, but still a bound.
template <typename LowerBound, typename Value>
EnclosedMinimum smallest_value(double low, double high, const MinimumSearch& search, LowerBound lower_bound,
                               Value value) {
  struct Cell {
    double low, high;
    int depth;
  };
  constexpr int max_depth = 48;
  EnclosedMinimum minimum;
  const auto try_value = [&](double x) {
    if (const double v = value(x); v < minimum.attained) minimum.attained = v, minimum.argument = x;
  };
  const auto enough = [&] {
    const double tight = minimum.attained - search.tolerance;
    return minimum.attained < search.threshold ? tight : std::max(tight, search.threshold);
  };
  const bool verdict_only = search.tolerance == std::numeric_limits<double>::infinity();

  try_value(high);
  std::array<Cell, max_depth + 2> open;
  int count = 0, visited = 0;
  open[count++] = {low, high, 0};
  while (count > 0) {
    if (verdict_only && minimum.attained < search.threshold) {
      minimum.proved = -std::numeric_limits<double>::infinity();
      return minimum;
    }
    const Cell cell = open[--count];
    const double bound = lower_bound(cell.low, cell.high, enough());
    if (bound >= enough() || cell.depth == max_depth || ++visited > search.max_halvings) {
      minimum.proved = std::min(minimum.proved, bound);
      continue;
    }
    const double middle = 0.5 * (cell.low + cell.high);
    try_value(middle);
    open[count++] = {cell.low, middle, cell.depth + 1};
    open[count++] = {middle, cell.high, cell.depth + 1};
  }
  return minimum;
}

}  // namespace cps
