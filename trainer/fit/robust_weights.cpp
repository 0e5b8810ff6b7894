#include "trainer/fit/robust_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/quantile.h"

namespace cps {

double student_weight(double squared_distance, int dimensions, double degrees_of_freedom) {
  return std::min(1.0, (degrees_of_freedom + dimensions) / (degrees_of_freedom + squared_distance));
}

double robust_deviation(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  constexpr double by_median = 1.4826;  // of a normal distribution
  return by_median * quantile(std::move(values), .5);
}

std::vector<double> tilt_residuals(const FrameEvidence& frame, const FitVector& parameters) {
  const TiltModel model = tilt_model(frame, parameters);
  std::vector<double> residuals(model.tilt.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double weight = frame.edges.weight[i];
    if (model.has_tilt[i] && weight > 0)
      residuals[i] = (frame.edges.weighted_tilt[i] - weight * model.tilt[i]) / std::sqrt(weight);
  }
  return residuals;
}

void weigh_down(EdgeBlocks& edges, std::span<const double> residuals, double deviation,
                double degrees_of_freedom) {
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (std::isnan(residuals[i])) continue;
    const double in_deviations = residuals[i] / deviation;
    const auto factor =
        static_cast<float>(student_weight(in_deviations * in_deviations, 1, degrees_of_freedom));
    edges.weight[i] *= factor;
    edges.weighted_tilt[i] *= factor;
  }
}

}  // namespace cps
