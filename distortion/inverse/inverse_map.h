#pragma once

#include <Eigen/Geometry>
#include <array>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"
#include "distortion/tile_rect.h"

namespace cps {

/// The ideal points behind the pixel centres of one tile of a distorted image.
struct InverseMapTile {
  static constexpr int side = 64;
  int width = 0, height = 0;  ///< used part, ≤ side
  /// Row-major with stride `side`, on the plane z = 1; NaN where a pixel centre is proved to lie outside
  /// D(box).
  alignas(32) std::array<double, side * side> x, y;
  double worst_residual_px = 0;  ///< largest |D(ideal) − distorted|, pixels of the distorted image
  int outside = 0;               ///< pixels outside D(box)
  int fallbacks = 0;             ///< pixels left to undistort() by the vectorised steps

  int index(int column, int row) const { return row * side + column; }
};

/// Inverts the pixel centres of `rect`, which is at most `side` wide and high: undistort() at 5 × 5 Chebyshev
/// nodes of the tile, interpolation between them, then Newton steps on many pixels at once. Pixels that these
/// leave with a residual above 1e-9 px, or outside the box, are solved again by undistort(). The lens must be
/// certified on the box.
void invert_tile(const Distortion& lens, const Eigen::AlignedBox2d& box, const Pinhole& camera,
                 const TileRect& rect, InverseMapTile& tile);

}  // namespace cps
