#include "trainer/calibration/lens_posterior.h"

#include <algorithm>
#include <cmath>

namespace cps {

OutputCovariance correlation(std::span<const Outputs> targets) {
  constexpr double identity_share = .01;
  const Standardisation by = fit_standardisation(targets);
  OutputCovariance sums = OutputCovariance::Zero();
  for (const Outputs& target : targets) {
    const Outputs standard = standardise(target, by);
    const auto row = Eigen::Map<const Eigen::Matrix<double, output_count, 1>>(standard.data());
    sums += row * row.transpose() / static_cast<double>(targets.size());
  }
  OutputCovariance result = (1 - identity_share) * sums;
  result.diagonal().setOnes();
  return result;
}

Outputs LensPosterior::deviation() const {
  Outputs result;
  for (int i = 0; i < output_count; ++i) result[i] = std::sqrt(std::max(0.0, covariance(i, i)));
  return result;
}

LensPosterior convert(const LensPosterior& posterior, TargetSpace from, TargetSpace to, int width,
                      int height) {
  if (from == to) return posterior;
  constexpr double share = .01;
  const Outputs deviation = posterior.deviation();
  OutputCovariance slopes;
  for (int i = 0; i < output_count; ++i) {
    const double step = std::max(share * deviation[i], 1e-9);
    Outputs low = posterior.mean, high = posterior.mean;
    low[i] -= step;
    high[i] += step;
    low = convert(low, from, to, width, height);
    high = convert(high, from, to, width, height);
    for (int k = 0; k < output_count; ++k) slopes(k, i) = (high[k] - low[k]) / (2 * step);
  }
  return {convert(posterior.mean, from, to, width, height),
          slopes * posterior.covariance * slopes.transpose()};
}

}  // namespace cps
