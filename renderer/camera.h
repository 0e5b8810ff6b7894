#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// A camera in the world. Camera frame: x right, y down, z forward.
struct Camera {
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  Pinhole pinhole;  ///< what the picture's pixels mean
  /// The picture is seen through this lens, each ray by itself. The lens must be one-to-one on all that the
  /// picture shows.
  std::optional<Distortion> lens = {};
};

}  // namespace cps
