#pragma once

#include <array>

#include "distortion/models/warp/proved_camera.h"
#include "distortion/tile_rect.h"
#include "distortion/warp/footprints.h"

namespace cps {

/// The rays through the pixel centres of one tile of an image, and how they move with the pixel. Arrays are
/// row-major with stride `side`.
struct RayTile {
  static constexpr int side = FootprintTile::side;
  using Values = std::array<double, side * side>;
  int width = 0, height = 0;      ///< used part, ≤ side
  alignas(32) Values x, y, z;     ///< unit ray, camera frame; NaN where the camera shows none
  alignas(32) Values xu, yu, zu;  ///< ∂ray/∂column, per pixel
  alignas(32) Values xv, yv, zv;  ///< ∂ray/∂row, per pixel
  double worst_residual_px = 0;   ///< largest distance of a ray's image from its pixel's centre

  bool is_seen(int index) const { return x[index] == x[index]; }
  Eigen::Vector3d ray(int index) const { return {x[index], y[index], z[index]}; }
  /// ∂ray/∂(column, row).
  Eigen::Matrix<double, 3, 2> jacobian(int index) const {
    Eigen::Matrix<double, 3, 2> result;
    result << xu[index], xv[index], yu[index], yv[index], zu[index], zv[index];
    return result;
  }
  void set(int index, const Eigen::Vector3d& ray, const Eigen::Matrix<double, 3, 2>& jacobian);
  void set_unseen(int index);
};

/// Fills the tile for the pixels in `rect`, which is at most RayTile::side wide and high.
void unproject_tile(const ProvedCamera& camera, const TileRect& rect, RayTile& tile);

}  // namespace cps
