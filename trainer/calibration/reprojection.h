#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// Pixels spread evenly over an image, and the ideal (undistorted) point on the plane z = 1 that each shows
/// through the true lens.
struct RayGrid {
  std::vector<Eigen::Vector2d> pixels, ideal;
};

/// About `columns` × columns·H/W pixels at the centres of equal cells of the frame, row by row.
std::vector<Eigen::Vector2d> pixel_grid(const Pinhole& camera, int columns);

/// The points of pixel_grid(): all of them if the lens is one-to-one
/// in its whole frame. Otherwise those inside the largest certified rectangle (the lens of KITTI's camera 03
/// folds just beyond its corners); empty if that is less than nine tenths of the grid, because then too many
/// pixels show no single point. Rectangles are similar to `shape`, see certify_frame(). For a drawn lens that
/// is the frame of its base camera, on which it was certified; by default it is the camera's own frame.
std::optional<RayGrid> ray_grid(const CalibratedCamera& truth, const Eigen::AlignedBox2d& shape,
                                int columns = 24);
std::optional<RayGrid> ray_grid(const CalibratedCamera& truth, int columns = 24);

/// The whole grid, with few enough points for a training loss. Throws std::runtime_error that starts with
/// `label`, the name of the label file, if no certified rectangle similar to `shape` covers the whole grid.
std::shared_ptr<const RayGrid> loss_rays(const CalibratedCamera& truth, const Eigen::AlignedBox2d& shape,
                                         const std::string& label);

/// Mean distance in pixels between the true and the predicted image of each grid point. Needs no inverse of
/// the predicted lens, so it is defined for a lens that folds, too.
double reprojection_error_px(const RayGrid& truth, const CalibratedCamera& prediction);

/// Mean angle in degrees between the true and the predicted ray of each grid pixel. Empty if the predicted
/// lens is not one-to-one in its frame: then a pixel has no unique ray.
std::optional<double> angular_error_deg(const RayGrid& truth, const CalibratedCamera& prediction);

/// Whether every pixel of the frame shows exactly one point.
bool is_one_to_one(const CalibratedCamera& camera);

}  // namespace cps
