#pragma once

#include <Eigen/Geometry>
#include <array>

#include "distortion/brown_conrady.h"
#include "distortion/inverse/inverse_map.h"
#include "distortion/pinhole.h"
#include "distortion/tile_rect.h"
#include "distortion/warp/pixel_kernel.h"

namespace cps {

/// The kernels of one row of an output tile, in source pixels.
struct KernelRow {
  static constexpr int side = InverseMapTile::side;
  /// C⁻¹ / support², and the half width and height of the ellipse's bounding box.
  alignas(32) std::array<float, side> conic_xx, conic_xy, conic_yy, half_width, half_height;
};

/// For each pixel of an output tile: where the ray through its centre meets the source image, and the kernel
/// that gathers the pixel from it. In source pixels; plain arrays are row-major with stride `side`.
struct FootprintTile {
  static constexpr int side = InverseMapTile::side;
  int width = 0, height = 0;                         ///< used part, ≤ side
  alignas(32) std::array<double, side * side> x, y;  ///< centre; NaN: the ray is outside the source
  std::array<KernelRow, side> kernels;               ///< by row
  /// Smaller eigenvalue of C, before it is raised to narrowest_sigma_px² where it is below.
  alignas(32) std::array<float, side * side> smaller_variance;
  double worst_residual_px = 0;  ///< of the inversion; 0 where there was none
};

/// A = ∂source px/∂output px of one row of output pixels.
struct PixelJacobianRow {
  alignas(32) std::array<double, KernelRow::side> xx, xy, yx, yy;
};

/// Sets the kernels of one row of the tile, tile.width of them, from their Jacobians: pixel_kernel() of each,
/// with square source pixels. `sigma_px` is the standard deviation of the output pixel's kernel, output
/// pixels.
void kernels_of_row(const PixelJacobianRow& jacobian, double sigma_px, int row, FootprintTile& tile);

/// Resampling through a lens: of which camera's image, into which, with which kernel.
struct ResamplingGeometry {
  Distortion lens;
  Eigen::AlignedBox2d box;  ///< ideal points on which the lens is one-to-one
  Pinhole source, output;
  double sigma_px = 0;  ///< standard deviation of the output pixel's kernel, output pixels
};

/// Footprints of the output pixels in `rect`, which is at most FootprintTile::side wide and high.
///
/// Distorting: the output is seen through the lens, the source is ideal.
void distorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile);

/// Undistorting: the output is ideal, the source was seen through the lens. Output pixels beyond the box get
/// NaN, since a lens that folds there would show a second time what it already shows inside.
void undistorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile);

}  // namespace cps
