#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trainer/calibration/targets.h"

namespace cps {

/// Pixels spread evenly over an image, and the ideal point on the plane z = 1 that each shows through the
/// true lens.
struct RayGrid {
  std::vector<Eigen::Vector2d> pixels, ideal;
};

/// About `columns` × columns·H/W points at the centres of equal cells. Where the lens is one-to-one in its
/// whole frame, all of them. Else those that the largest certified rectangle shows (KITTI's camera 03 folds
/// just beyond its corners); empty when that is less than nine tenths: then most pixels show no one point.
/// Rectangles are similar to `shape`, see certify_frame(): for a lens that was drawn, the frame of its base,
/// on which it is certified; else the camera's own.
std::optional<RayGrid> ray_grid(const Calibration& truth, const Eigen::AlignedBox2d& shape, int columns = 24);
std::optional<RayGrid> ray_grid(const Calibration& truth, int columns = 24);

/// The whole grid, coarse enough for a loss. Throws std::runtime_error that starts with `label`, the file to
/// blame, when a certified rectangle similar to `shape` does not show all of it.
std::shared_ptr<const RayGrid> loss_rays(const Calibration& truth, const Eigen::AlignedBox2d& shape,
                                         const std::string& label);

/// Mean distance in pixels between where the truth and where the prediction puts the grid's points. Needs no
/// inverse of the predicted lens, so a lens that folds is judged like any other.
double reprojection_error_px(const RayGrid& truth, const Calibration& prediction);

/// Mean angle in degrees between the truth's ray of a pixel and the prediction's. Empty when the predicted
/// lens is not one-to-one in its frame: then a pixel has no one ray.
std::optional<double> angular_error_deg(const RayGrid& truth, const Calibration& prediction);

/// Whether every pixel of the frame shows exactly one point.
bool is_one_to_one(const Calibration& calibration);

}  // namespace cps
