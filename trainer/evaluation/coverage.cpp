#include "trainer/evaluation/coverage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps {

double normal_share(double deviations) {
  return std::erf(deviations / std::numbers::sqrt2);
}

Coverage coverage_of(std::span<const Outputs> errors, std::span<const Outputs> deviations) {
  Coverage coverage;
  const double n = static_cast<double>(errors.size());
  for (int k = 0; k < output_count; ++k) {
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double ratio = std::abs(errors[i][k]) / std::max(deviations[i][k], 1e-300);
      coverage.within_one[k] += (ratio <= 1) / n;
      coverage.within_two[k] += (ratio <= 2) / n;
      coverage.scaled_error[k] += ratio * ratio / n;
      for (int point = 0; point < reliability_points; ++point)
        coverage.within[point][k] += (ratio <= reliability_deviations(point)) / n;
    }
    coverage.scaled_error[k] = std::sqrt(coverage.scaled_error[k]);
  }
  return coverage;
}

}  // namespace cps
