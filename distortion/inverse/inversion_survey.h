#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// Errors of one of the usual iterative inverses on a whole image, against undistort().
struct InverterErrors {
  std::string name;
  std::int64_t wrong_pixels = 0;           ///< pixels whose ideal point is off by more than tolerance_px
  double worst_px = 0;                     ///< infinite where it diverges
  double first_wrong_radius_px = 0;        ///< from the principal point; 0 when nothing is wrong
  Eigen::Vector2d first_wrong_px{-1, -1};  ///< the wrong pixel nearest to the principal point
};

/// The inverses compared at the pixel centres of an image.
struct InversionSurvey {
  static constexpr double tolerance_px = 0.1;  ///< of ideal points, in pixels at the image's focal length
  std::int64_t pixels = 0;       ///< examined: all, or a regular grid of about a million of a larger image
  std::int64_t outside = 0;      ///< of those, proved to lie outside D(box)
  double worst_residual_px = 0;  ///< of undistort(), |D(x) − distorted|
  std::vector<InverterErrors> others;  ///< on the pixels that are not outside
};

/// `box` is a rectangle of ideal points on which the lens is certified. Gives the same result for any number
/// of threads.
InversionSurvey survey_inversion(const CalibratedCamera& calibrated, const Eigen::AlignedBox2d& box);

}  // namespace cps
