#pragma once

#include <Eigen/Core>
#include <vector>

#include "distortion/models/model_camera.h"

/// The fit of convert.h.
namespace cps {

/// Rays of a camera and the pixels that show them.
struct SeenRays {
  Eigen::Matrix3Xd rays;     ///< camera frame, unit length
  Eigen::Matrix2Xd pixels;   ///< a column for each ray
  double max_angle_rad = 0;  ///< largest angle between a ray and the axis
};

/// The sum of the squared reprojection errors, px². Infinite if one of the rays lies beyond angle_limit() of
/// the camera's lens, or its point is not finite.
double squared_error_px2(const ModelCamera& camera, const SeenRays& seen);

/// What a fit may change besides the scale of both focal lengths.
struct FreeVariables {
  bool pinhole = false;         ///< fx, fy, cx and cy, each for itself
  std::vector<int> parameters;  ///< of the lens: places in parameters()
};

/// The camera with the smallest squared error that Levenberg–Marquardt steps (Marquardt 1963) lead to from
/// `start`, at most 200 of them. Parameters keep their family's range: one at its end is left out while the
/// error would fall beyond it. Unchecked: the error of `start` is finite.
ModelCamera fitted(const ModelCamera& start, const SeenRays& seen, const FreeVariables& free);

}  // namespace cps
