#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cps {

/// Quantile q of a sample, by linear interpolation between order statistics; 0 for an empty one.
inline double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const double place = q * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place), above = std::min(below + 1, values.size() - 1);
  if (values[below] == values[above]) return values[below];  // also where both are infinite
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

}  // namespace cps
