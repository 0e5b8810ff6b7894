#include "trainer/lens_errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cps {
namespace {

double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
}

void add_errors(const Outputs& said, const Outputs& truth, Outputs& absolute, Outputs& squared) {
  for (int i = 0; i < output_count; ++i) {
    absolute[i] += std::abs(said[i] - truth[i]);
    squared[i] += (said[i] - truth[i]) * (said[i] - truth[i]);
  }
}

}  // namespace

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const double place = q * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place), above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

LensErrors measure_errors(std::span<const LensVerdict> verdicts) {
  LensErrors errors;
  errors.images = static_cast<int>(verdicts.size());
  std::vector<double> hfov_deg, reprojection_px;
  for (const LensVerdict& verdict : verdicts) {
    const auto [width, height] = std::pair{verdict.truth->camera.width, verdict.truth->camera.height};
    const Outputs truth = to_outputs(*verdict.truth, TargetSpace::raw);
    add_errors(verdict.said, truth, errors.raw_mae, errors.raw_rmse);
    add_errors(convert(verdict.said, TargetSpace::raw, TargetSpace::apparent, width, height),
               to_outputs(*verdict.truth, TargetSpace::apparent), errors.apparent_mae, errors.apparent_rmse);
    hfov_deg.push_back(degrees(std::abs(verdict.said[0] - truth[0])));

    const auto calibration = to_calibration(verdict.said, TargetSpace::raw, width, height);
    if (!calibration) {
      ++errors.without_camera;
      continue;
    }
    reprojection_px.push_back(reprojection_error_px(*verdict.rays, *calibration));
    if (!is_one_to_one(*calibration)) ++errors.folding;
  }
  const double n = static_cast<double>(verdicts.size());
  for (Outputs* sums : {&errors.raw_mae, &errors.apparent_mae})
    for (double& v : *sums) v /= n;
  for (Outputs* sums : {&errors.raw_rmse, &errors.apparent_rmse})
    for (double& v : *sums) v = std::sqrt(v / n);
  errors.hfov_mean_deg = mean(hfov_deg);
  errors.hfov_median_deg = quantile(hfov_deg, .5);
  errors.reprojection_mean_px = mean(reprojection_px);
  errors.reprojection_median_px = quantile(reprojection_px, .5);
  errors.reprojection_p95_px = quantile(reprojection_px, .95);
  return errors;
}

}  // namespace cps
