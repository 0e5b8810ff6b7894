#include "distortion/warp/footprints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cps {
namespace {

constexpr int side = FootprintTile::side;

/// A_ij = scale_ij · ∂source plane_i/∂output plane_j.
PixelJacobian plane_to_pixels(const ResamplingGeometry& geometry) {
  return {.xx = geometry.source.fx / geometry.output.fx,
          .xy = geometry.source.fx / geometry.output.fy,
          .yx = geometry.source.fy / geometry.output.fx,
          .yy = geometry.source.fy / geometry.output.fy};
}

/// Jacobians of a row of pixels from the lens' own, which is symmetric, or its inverse, at their ideal
/// points. Written without branches or calls so that it compiles to vector instructions.
template <bool inverted>
void jacobians_of_row(const Distortion lens, const PixelJacobian scale, int count, const double* __restrict x,
                      const double* __restrict y, PixelJacobianRow& __restrict jacobian) {
  for (int i = 0; i < count; ++i) {
    const DistortedPoint at = evaluate(lens, x[i], y[i]);
    const double inverse = inverted ? 1 / (at.xx * at.yy - at.xy * at.xy) : 1;
    const double slant = inverse * (inverted ? -at.xy : at.xy);
    jacobian.xx[i] = scale.xx * (inverse * (inverted ? at.yy : at.xx));
    jacobian.xy[i] = scale.xy * slant;
    jacobian.yx[i] = scale.yx * slant;
    jacobian.yy[i] = scale.yy * (inverse * (inverted ? at.xx : at.yy));
  }
}

void start(FootprintTile& tile, const TileRect& rect) {
  tile.width = rect.width;
  tile.height = rect.height;
  tile.worst_residual_px = 0;
}

}  // namespace

// Without branches or calls, as pixel_kernel() is, so that the loop compiles to vector instructions.
void kernels_of_row(const PixelJacobianRow& __restrict jacobian, double sigma_px, int row,
                    FootprintTile& __restrict tile) {
  const int count = tile.width;
  const double variance = sigma_px * sigma_px;
  KernelRow& __restrict kernels = tile.kernels[row];
  float* __restrict smaller_variance = &tile.smaller_variance[row * side];
  for (int i = 0; i < count; ++i) {
    const PixelKernel kernel = pixel_kernel({jacobian.xx[i], jacobian.xy[i], jacobian.yx[i], jacobian.yy[i]},
                                            variance, pixel_variance, pixel_variance);
    kernels.conic_xx[i] = static_cast<float>(kernel.conic_xx);
    kernels.conic_xy[i] = static_cast<float>(kernel.conic_xy);
    kernels.conic_yy[i] = static_cast<float>(kernel.conic_yy);
    kernels.half_width[i] = static_cast<float>(kernel.half_width);
    kernels.half_height[i] = static_cast<float>(kernel.half_height);
    smaller_variance[i] = static_cast<float>(kernel.smaller_variance);
  }
}

void distorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile) {
  start(tile, rect);
  InverseMapTile ideal;
  invert_tile(geometry.lens, geometry.box, geometry.output, rect, ideal);
  tile.worst_residual_px = ideal.worst_residual_px;

  const Pinhole& source = geometry.source;
  const PixelJacobian scale = plane_to_pixels(geometry);
  PixelJacobianRow jacobian;
  for (int row = 0; row < rect.height; ++row) {
    const int first = row * side;
    for (int i = 0; i < rect.width; ++i) {
      tile.x[first + i] = source.fx * ideal.x[first + i] + source.cx;
      tile.y[first + i] = source.fy * ideal.y[first + i] + source.cy;
    }
    jacobians_of_row<true>(geometry.lens, scale, rect.width, &ideal.x[first], &ideal.y[first], jacobian);
    kernels_of_row(jacobian, geometry.sigma_px, row, tile);
  }
}

void undistorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile) {
  start(tile, rect);
  const PixelJacobian scale = plane_to_pixels(geometry);
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<double, side> x, y;
  PixelJacobianRow jacobian;
  for (int row = 0; row < rect.height; ++row) {
    const int first = row * side;
    for (int i = 0; i < rect.width; ++i) {
      const Eigen::Vector2d ideal = to_plane(geometry.output, {rect.x0 + i, rect.y0 + row});
      const Eigen::Vector2d position =
          geometry.box.contains(ideal) ? to_pixel(geometry.source, distort(geometry.lens, ideal)) : nowhere;
      x[i] = ideal.x();
      y[i] = ideal.y();
      tile.x[first + i] = position.x();
      tile.y[first + i] = position.y();
    }
    jacobians_of_row<false>(geometry.lens, scale, rect.width, x.data(), y.data(), jacobian);
    kernels_of_row(jacobian, geometry.sigma_px, row, tile);
  }
}

}  // namespace cps
