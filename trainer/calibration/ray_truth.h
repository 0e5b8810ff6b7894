#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "distortion/models/model_camera.h"
#include "trainer/calibration/reprojection.h"

/// What a picture of a known camera of any lens family shows, as rays: the ground on which predictions of
/// different families are compared.
namespace cps {

/// Rays are unit vectors in the camera frame (x right, y down, z forward).
struct RayTruth {
  ModelCamera camera;
  std::vector<Eigen::Vector2d> pixels;  ///< those of pixel_grid() that show a ray
  std::vector<Eigen::Vector3d> rays;    ///< that they show
  /// seen_hfov_rad(): the angle along the principal point's row; empty if an end of it shows no ray.
  std::optional<double> seen_hfov_rad;
};

/// Of a Brown–Conrady camera, on the points of its ray_grid(). `shape` as there.
std::shared_ptr<const RayTruth> ray_truth(const CalibratedCamera& camera, const RayGrid& grid,
                                          const Eigen::AlignedBox2d& shape);

/// Of a camera of any family, on `columns` × columns·H/W pixels, less those that the lens is not proved to
/// show; null if they are more than half of the grid, or, for Brown–Conrady, if there is no ray_grid().
std::shared_ptr<const RayTruth> ray_truth(const ModelCamera& camera, int columns = 24);

}  // namespace cps
