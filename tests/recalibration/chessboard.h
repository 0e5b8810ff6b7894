#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"
#include "random/counter_hash.h"
#include "renderer/render.h"
#include "scenes/scene.h"

namespace cps {

/// A chessboard large enough to fill any frame: squares of 1 m in the plane z = 0, facing +z, with
/// corners at all integers.
Scene chessboard_scene();

/// Number `index` of the poses from which the board is photographed: some thirty squares across the frame,
/// tilted by 15° to 40° (less where the view is wide) in a random direction, rolled, at a random phase of the
/// squares.
Eigen::Isometry3d chessboard_pose(const Pinhole& base, Stream stream, std::uint64_t index);

/// A corner of the board and the pixel in which a lens shows it.
struct BoardCorner {
  Eigen::Vector2d on_board;
  Eigen::Vector2d pixel;
};

/// The corners whose surroundings can be measured: at least `border_px` inside the frame, squares around
/// them not smaller than `min_square_px` in either direction, and not sheared beyond 35°. `seen` is the
/// rectangle on the plane z = 1 on which the lens is known to be one-to-one.
std::vector<BoardCorner> visible_corners(const Eigen::Isometry3d& world_from_camera, const Pinhole& camera,
                                         const Distortion& lens, const Eigen::AlignedBox2d& seen,
                                         double border_px, double min_square_px);

}  // namespace cps
