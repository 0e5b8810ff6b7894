#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "trainer/calibration/reprojection.h"
#include "trainer/calibration/targets.h"

namespace cps {

/// One test image: the true camera and the prediction.
struct LensPrediction {
  const CalibratedCamera* truth = nullptr;
  const RayGrid* rays = nullptr;  ///< ray_grid(*truth)
  Outputs predicted{};            ///< in raw space
};

/// Errors of one prediction.
struct ImageErrors {
  Outputs raw{}, apparent{};  ///< predicted − true; raw as published: fov in radians, cx/w, cy/h
  double hfov_deg = 0;        ///< |predicted − true|
  /// Zhu et al. 2023 (WildCamera): max(|Δfx|/fx, |Δfy|/fy), and 2·max(|Δcx|/w, |Δcy|/h). The first is
  /// infinite if the prediction is not a camera.
  double focal = 0, principal_point = 0;
  double k1 = 0;                          ///< |Δk1|
  std::optional<double> reprojection_px;  ///< empty: not a camera (H-FOV outside 0…180°)
  std::optional<double> angle_deg;        ///< mean angle between the true and the predicted ray of
                                          ///< a pixel; empty: not a camera, or its lens folds
  bool folds = false;                     ///< not one-to-one in its frame
};

/// Compares one prediction with the truth.
ImageErrors image_errors(const LensPrediction& prediction);

/// Errors over a set of predictions.
struct LensErrors {
  int images = 0;
  Outputs raw_mae{}, raw_mse{}, raw_rmse{};
  /// Coefficients scaled by the half diagonal: comparable across H-FOV.
  Outputs apparent_mae{}, apparent_rmse{};
  double hfov_mean_deg = 0, hfov_median_deg = 0;
  /// Area under the curve of the fraction of images within an error, from 0 to the threshold, divided by the
  /// threshold (Sarlin et al. 2020; GeoCalib): the mean of max(0, 1 − error / threshold).
  static constexpr std::array<double, 3> auc_thresholds_deg{1, 5, 10};
  std::array<double, 3> hfov_auc{};
  double hfov_correlation = 0;  ///< Pearson's, of predicted and true H-FOV; 0 if either is constant
  double focal_median = 0, principal_point_mean = 0, k1_mean = 0;
  double reprojection_mean_px = 0, reprojection_median_px = 0,
         reprojection_p95_px = 0;                   ///< over the predictions that are cameras
  double angle_mean_deg = 0, angle_median_deg = 0;  ///< over the one-to-one predictions
  int without_camera =
      0;            ///< predictions that are not a camera (H-FOV outside 0…180°): no reprojection error
  int folding = 0;  ///< predicted lenses that are not one-to-one in their frame; measured as they are
};

/// Coefficient of determination: 1 − mean squared error / variance of the truth. 1 where there is no error, 0
/// for always predicting the mean of these very truths, less where that were better; 0 also if the truth does
/// not vary. Entry i of both arguments belongs to image i.
double r_squared(std::span<const double> truth, std::span<const double> error);

/// Means, medians and quantiles of the errors. Entry i of both arguments belongs to image i.
LensErrors summarise(std::span<const ImageErrors> errors, std::span<const double> true_fov_rad);

/// image_errors() of each prediction, summarised.
LensErrors measure_errors(std::span<const LensPrediction> predictions);

}  // namespace cps
