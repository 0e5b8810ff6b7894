#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "trainer/calibration/reprojection.h"

namespace cps {

/// One test image: what is true, and what was said of it.
struct LensVerdict {
  const Calibration* truth = nullptr;
  const RayGrid* rays = nullptr;  ///< ray_grid(*truth)
  Outputs said{};                 ///< in raw space
};

/// How wrong one prediction is.
struct ImageErrors {
  Outputs raw{}, apparent{};  ///< said − true; raw as published: fov in radians, cx/w, cy/h
  double hfov_deg = 0;        ///< |said − true|
  /// Zhu et al. 2023 (WildCamera): max(|Δfx|/fx, |Δfy|/fy), and 2·max(|Δcx|/w, |Δcy|/h). The first is
  /// infinite where the prediction is no camera.
  double focal = 0, principal_point = 0;
  double k1 = 0;                          ///< |Δk1|
  std::optional<double> reprojection_px;  ///< empty: no camera (H-FOV outside 0…180°)
  std::optional<double> angle_deg;        ///< mean angle between the true ray of a pixel and the
                                          ///< predicted one; empty: no camera, or one that folds
  bool folds = false;                     ///< not one-to-one in its frame
};

ImageErrors image_errors(const LensVerdict& verdict);

/// How wrong a set of predictions is.
struct LensErrors {
  int images = 0;
  Outputs raw_mae{}, raw_mse{}, raw_rmse{};
  /// Coefficients scaled by the half diagonal: comparable across H-FOV.
  Outputs apparent_mae{}, apparent_rmse{};
  double hfov_mean_deg = 0, hfov_median_deg = 0;
  /// Area under the share of images within an error, from 0 to the threshold, as a share of the threshold
  /// (Sarlin et al. 2020; GeoCalib): the mean of max(0, 1 − error / threshold).
  static constexpr std::array<double, 3> auc_thresholds_deg{1, 5, 10};
  std::array<double, 3> hfov_auc{};
  double hfov_correlation = 0;  ///< Pearson's, of said and true H-FOV; 0 where either does not vary
  double focal_median = 0, principal_point_mean = 0, k1_mean = 0;
  double reprojection_mean_px = 0, reprojection_median_px = 0, reprojection_p95_px = 0;  ///< over the rest
  double angle_mean_deg = 0, angle_median_deg = 0;  ///< over the one-to-one predictions
  int without_camera = 0;  ///< predictions that are no camera (H-FOV outside 0…180°): no reprojection error
  int folding = 0;  ///< predicted lenses that are not one-to-one in their frame; counted, never repaired
};

/// Quantile q of a sample, by linear interpolation between order statistics; 0 for an empty one.
double quantile(std::vector<double> values, double q);

/// `true_fov_rad` and errors, image by image.
LensErrors summarise(std::span<const ImageErrors> errors, std::span<const double> true_fov_rad);

LensErrors measure_errors(std::span<const LensVerdict> verdicts);

}  // namespace cps
