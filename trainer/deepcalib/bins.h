#pragma once

#include <algorithm>
#include <cmath>

/// The classes of DeepCalib's classification (Bogdan et al. 2018): values spread evenly over an interval,
/// both ends included. A bin is what is nearer to its value than to any other.
namespace cps {

/// Focal lengths 50, 60 … 500 pixels; ξ 0, .02 … 1.2.
inline constexpr int focal_bins = 46, xi_bins = 61;

/// The bin of a share of the interval; a share on a border belongs to the upper bin. `share`: 0 … 1.
inline int nearest_bin(double share, int bins) {
  return std::clamp(static_cast<int>(std::round(share * (bins - 1))), 0, bins - 1);
}

/// The value of a bin, as a share of the interval.
inline double bin_share(int bin, int bins) {
  return static_cast<double>(bin) / (bins - 1);
}

}  // namespace cps
