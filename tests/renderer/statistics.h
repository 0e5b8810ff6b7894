#pragma once

#include <boost/math/distributions/chi_squared.hpp>
#include <vector>

namespace cps {

/// Probability that draws as far from `expected` counts, or farther, come from that distribution (Pearson).
/// Cells of fewer than five expected draws are pooled.
inline double chi_squared_p_value(const std::vector<double>& observed, const std::vector<double>& expected) {
  double statistic = 0, pooled_observed = 0, pooled_expected = 0;
  int cells = 0;
  const auto count = [&](double o, double e) {
    statistic += (o - e) * (o - e) / e;
    ++cells;
  };
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (expected[i] >= 5) {
      count(observed[i], expected[i]);
    } else {
      pooled_observed += observed[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected >= 5) count(pooled_observed, pooled_expected);
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(cells - 1), statistic));
}

}  // namespace cps
