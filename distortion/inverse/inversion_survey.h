#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// How one of the usual iterations does on a whole image, against the proved inverse.
struct InverterErrors {
  std::string name;
  std::int64_t wrong_pixels = 0;           ///< whose ideal point is off by more than `tolerance_px`
  double worst_px = 0;                     ///< infinite where it diverges
  double first_wrong_radius_px = 0;        ///< from the principal point; 0 when nothing is wrong
  Eigen::Vector2d first_wrong_px{-1, -1};  ///< the wrong pixel nearest to the principal point
};

/// The inverse over all pixel centres of an image.
struct InversionSurvey {
  static constexpr double tolerance_px = 0.1;  ///< of ideal points, in pixels at the image's focal length
  std::int64_t pixels = 0;   ///< looked at: all of them, or of a big image a regular grid of about a million
  std::int64_t outside = 0;  ///< of those, proved to lie outside D(box)
  double worst_residual_px = 0;        ///< of our inverse, |D(x) − distorted|
  std::vector<InverterErrors> others;  ///< on the pixels that are not outside
};

/// `box` is a rectangle of ideal points on which the lens is certified. The same for any number of threads.
InversionSurvey survey_inversion(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box);

}  // namespace cps
