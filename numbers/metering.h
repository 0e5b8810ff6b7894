#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace cps {

/// The factor that brings the mean of luminances to 18 % of white. One counts at most eight times the median,
/// so that the sun does not set the exposure. None if that leaves only black. Needs at least one; changes
/// their order.
inline std::optional<double> metered_exposure(std::vector<float>& luminances) {
  constexpr double key = 0.18;
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  const float brightest = 8 * *middle;
  double sum = 0;
  for (float luminance : luminances) sum += std::min(luminance, brightest);
  if (!(sum > 0)) return {};
  return key * static_cast<double>(luminances.size()) / sum;
}

}  // namespace cps
