#include "trainer/evaluation/lens_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "numbers/angles.h"
#include "numbers/quantile.h"

namespace cps {
namespace {

double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
}

Outputs difference(const Outputs& a, const Outputs& b) {
  Outputs result;
  for (int i = 0; i < output_count; ++i) result[i] = a[i] - b[i];
  return result;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double mean_a = mean(a), mean_b = mean(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  const double n = static_cast<double>(a.size());
  return aa > 1e-18 * n && bb > 1e-18 * n ? ab / std::sqrt(aa * bb) : 0;
}

/// One field of all errors, where it has a value.
template <typename Field>
std::vector<double> values_of(std::span<const ImageErrors> errors, Field field) {
  std::vector<double> values;
  for (const ImageErrors& e : errors)
    if (const std::optional<double> value = field(e)) values.push_back(*value);
  return values;
}

}  // namespace

double r_squared(std::span<const double> truth, std::span<const double> error) {
  const double mean_truth = mean({truth.begin(), truth.end()});
  double squared = 0, spread = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    squared += error[i] * error[i];
    spread += (truth[i] - mean_truth) * (truth[i] - mean_truth);
  }
  return spread > 1e-18 * static_cast<double>(truth.size()) ? 1 - squared / spread : 0;
}

ImageErrors image_errors(const LensPrediction& prediction) {
  const Pinhole& camera = prediction.truth->pinhole;
  const Outputs truth = to_outputs(*prediction.truth, TargetSpace::raw);
  ImageErrors e;
  e.raw = difference(prediction.predicted, truth);
  e.apparent = difference(
      convert(prediction.predicted, TargetSpace::raw, TargetSpace::apparent, camera.width, camera.height),
      to_outputs(*prediction.truth, TargetSpace::apparent));
  e.hfov_deg = degrees(std::abs(e.raw[0]));
  e.principal_point = 2 * std::max(std::abs(e.raw[6]), std::abs(e.raw[7]));
  e.k1 = std::abs(e.raw[1]);
  e.focal = std::numeric_limits<double>::infinity();

  const auto predicted = to_camera(prediction.predicted, TargetSpace::raw, camera.width, camera.height);
  if (!predicted) return e;
  e.focal = std::max(std::abs(predicted->pinhole.fx / camera.fx - 1),
                     std::abs(predicted->pinhole.fy / camera.fy - 1));
  e.reprojection_px = reprojection_error_px(*prediction.rays, *predicted);
  e.angle_deg = angular_error_deg(*prediction.rays, *predicted);
  e.folds = !e.angle_deg;
  return e;
}

LensErrors summarise(std::span<const ImageErrors> errors, std::span<const double> true_fov_rad) {
  LensErrors s;
  s.images = static_cast<int>(errors.size());
  const double n = std::max<double>(1, static_cast<double>(errors.size()));
  std::vector<double> predicted_fov;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const ImageErrors& e = errors[k];
    predicted_fov.push_back(true_fov_rad[k] + e.raw[0]);
    for (int i = 0; i < output_count; ++i) {
      s.raw_mae[i] += std::abs(e.raw[i]) / n;
      s.raw_mse[i] += e.raw[i] * e.raw[i] / n;
      s.apparent_mae[i] += std::abs(e.apparent[i]) / n;
      s.apparent_rmse[i] += e.apparent[i] * e.apparent[i] / n;
    }
    for (std::size_t t = 0; t < s.hfov_auc.size(); ++t)
      s.hfov_auc[t] += std::max(0.0, 1 - e.hfov_deg / LensErrors::auc_thresholds_deg[t]) / n;
    s.without_camera += !e.reprojection_px;
    s.folding += e.folds;
  }
  for (int i = 0; i < output_count; ++i) {
    s.raw_rmse[i] = std::sqrt(s.raw_mse[i]);
    s.apparent_rmse[i] = std::sqrt(s.apparent_rmse[i]);
  }
  const auto hfov = values_of(errors, [](const ImageErrors& e) { return std::optional(e.hfov_deg); });
  s.hfov_mean_deg = mean(hfov);
  s.hfov_median_deg = quantile(hfov, .5);
  s.hfov_correlation = correlation({true_fov_rad.begin(), true_fov_rad.end()}, predicted_fov);
  s.focal_median =
      quantile(values_of(errors, [](const ImageErrors& e) { return std::optional(e.focal); }), .5);
  s.principal_point_mean =
      mean(values_of(errors, [](const ImageErrors& e) { return std::optional(e.principal_point); }));
  s.k1_mean = mean(values_of(errors, [](const ImageErrors& e) { return std::optional(e.k1); }));
  const auto pixels = values_of(errors, [](const ImageErrors&e) { return e.reprojection_px; }),
             angles = values_of(errors, [](const ImageErrors&e) { return e.angle_deg; });
  s.reprojection_mean_px = mean(pixels);
  s.reprojection_median_px = quantile(pixels, .5);
  s.reprojection_p95_px = quantile(pixels, .95);
  s.angle_mean_deg = mean(angles);
  s.angle_median_deg = quantile(angles, .5);
  return s;
}

LensErrors measure_errors(std::span<const LensPrediction> predictions) {
  std::vector<ImageErrors> errors;
  std::vector<double> true_fov_rad;
  for (const LensPrediction& prediction : predictions) {
    errors.push_back(image_errors(prediction));
    true_fov_rad.push_back(hfov_rad(prediction.truth->pinhole));
  }
  return summarise(errors, true_fov_rad);
}

}  // namespace cps
