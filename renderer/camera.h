#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/models/lens_model.h"
#include "distortion/pinhole.h"

namespace cps {

/// A camera in the world. Camera frame: x right, y down, z forward.
struct Camera {
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  Pinhole pinhole;  ///< of the picture
  /// Each ray goes through this lens, of any family. One of the families of the plane (brown_conrady,
  /// rational) must be one-to-one on the whole picture; where another family is not, or its formula ends, the
  /// picture sees nothing.
  std::optional<LensModel> lens = {};
};

}  // namespace cps
