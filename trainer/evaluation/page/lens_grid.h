#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "distortion/calibrated_camera.h"

namespace cps {

/// A line of a grid, as a polyline.
using GridCurve = std::vector<Eigen::Vector2d>;

/// A straight grid of squares on the plane z = 1, as the camera shows it: in pixels of its picture from the
/// top left corner, also beyond the frame. `extent` is the rectangle of the grid on that plane, 12 squares
/// wide, with a line through its middle. Lines end where the lens is not proved one-to-one (certify_frame());
/// a camera that is refused there altogether shows none.
std::vector<GridCurve> lens_grid(const CalibratedCamera& camera, const Eigen::AlignedBox2d& extent);

}  // namespace cps
