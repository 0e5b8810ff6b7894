#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// A camera in the world. Camera frame: x right, y down, z forward.
struct Camera {
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  Pinhole pinhole;  ///< of the picture
  /// Each ray goes through this lens. It must be one-to-one on all that the picture shows.
  std::optional<Distortion> lens = {};
};

}  // namespace cps
