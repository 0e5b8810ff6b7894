#pragma once

#include <span>
#include <vector>

#include "trainer/reprojection.h"

namespace cps {

/// One test image: what is true, and what was said of it.
struct LensVerdict {
  const Calibration* truth = nullptr;
  const RayGrid* rays = nullptr;  ///< ray_grid(*truth)
  Outputs said{};                 ///< in raw space
};

/// How wrong a set of predictions is.
struct LensErrors {
  int images = 0;
  Outputs raw_mae{}, raw_rmse{};  ///< as published: fov in radians, cx/w, cy/h
  Outputs apparent_mae{},
      apparent_rmse{};  ///< coefficients scaled by the half diagonal: comparable across H-FOV
  double hfov_mean_deg = 0, hfov_median_deg = 0;
  double reprojection_mean_px = 0, reprojection_median_px = 0, reprojection_p95_px = 0;  ///< over the rest
  int without_camera = 0;  ///< predictions that are no camera (H-FOV outside 0…180°): no reprojection error
  int folding = 0;  ///< predicted lenses that are not one-to-one in their frame; counted, never repaired
};

/// Quantile q of a sample, by linear interpolation between order statistics; 0 for an empty one.
double quantile(std::vector<double> values, double q);

LensErrors measure_errors(std::span<const LensVerdict> verdicts);

}  // namespace cps
