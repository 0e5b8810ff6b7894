#pragma once

#include <Eigen/Geometry>
#include <array>

#include "distortion/brown_conrady.h"
#include "distortion/inverse/inverse_map.h"
#include "distortion/pinhole.h"
#include "distortion/tile_rect.h"

namespace cps {

/// The warp's kernel, k(d) = (1 − d·C⁻¹d / support²)³ inside the ellipse where that is positive: a piecewise
/// cubic in the squared distance that looks like a Gaussian, has covariance C exactly when support² = 10,
/// ends smoothly instead of being cut off, and costs four multiplications.
inline constexpr double kernel_support = 3.1622776601683795;  // √10 standard deviations

/// Narrowest kernel, source pixels. Below it a footprint holds so few samples that the image ripples with the
/// phase between the two pixel grids: by .002 px at .44, .06 px at .38 (docs/benchmarks/lens.md).
inline constexpr double narrowest_sigma_px = 0.42;

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

/// Resampling through a lens: of which camera's image, into which, with which kernel.
struct ResamplingGeometry {
  Distortion lens;
  Eigen::AlignedBox2d box;  ///< ideal points on which the lens is one-to-one
  Pinhole source, output;
  double sigma_px = 0;  ///< standard deviation of the output pixel's kernel, output pixels
};

/// Footprints of the output pixels in `rect`, which is at most FootprintTile::side wide and high. With
/// A = ∂source px/∂output px, the kernel's covariance is C = sigma² A Aᵀ − I/12; the second term because the
/// source's pixels are already averages over their squares.
///
/// Distorting: the output is seen through the lens, the source is ideal.
void distorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile);

/// Undistorting: the output is ideal, the source was seen through the lens. Output pixels beyond the box get
/// NaN, since a lens that folds there would show a second time what it already shows inside.
void undistorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile);

}  // namespace cps
