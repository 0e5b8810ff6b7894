#include "distortion/warp/footprints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cps {
namespace {

constexpr int side = FootprintTile::side;

/// Everything constant over a tile that turns a 2×2 plane-to-plane Jacobian into a kernel in source pixels.
struct KernelScale {
  double xx, xy, yx, yy;  ///< A_ij = scale_ij · jacobian_ij
  double variance;        ///< sigma²

  explicit KernelScale(const ResamplingGeometry& geometry)
      : xx(geometry.source.fx / geometry.output.fx),
        xy(geometry.source.fx / geometry.output.fy),
        yx(geometry.source.fy / geometry.output.fx),
        yy(geometry.source.fy / geometry.output.fy),
        variance(geometry.sigma_px * geometry.sigma_px) {}
};

/// Jacobians ∂source plane/∂output plane of one row of pixels; symmetric.
struct JacobianRow {
  alignas(32) std::array<double, side> xx, xy, yy;
};

/// Kernels of one row of the tile from its Jacobians. Written without branches or calls so that it compiles
/// to vector instructions.
void kernels_of_row(const KernelScale scale, const JacobianRow& __restrict jacobian, int row,
                    FootprintTile& __restrict tile) {
  constexpr double pixel_variance = 1.0 / 12, support2 = kernel_support * kernel_support;
  constexpr double narrowest = narrowest_sigma_px * narrowest_sigma_px;
  const int count = tile.width;
  KernelRow& __restrict kernels = tile.kernels[row];
  float* __restrict smaller_variance = &tile.smaller_variance[row * side];
  for (int i = 0; i < count; ++i) {
    const double axx = scale.xx * jacobian.xx[i], axy = scale.xy * jacobian.xy[i];
    const double ayx = scale.yx * jacobian.xy[i], ayy = scale.yy * jacobian.yy[i];
    double cxx = scale.variance * (axx * axx + axy * axy) - pixel_variance;
    double cyy = scale.variance * (ayx * ayx + ayy * ayy) - pixel_variance;
    const double cxy = scale.variance * (axx * ayx + axy * ayy);
    const double half_difference = 0.5 * (cxx - cyy);
    const double smaller = 0.5 * (cxx + cyy) - std::sqrt(half_difference * half_difference + cxy * cxy);
    const double lacking = narrowest - smaller > 0 ? narrowest - smaller : 0;
    cxx += lacking;
    cyy += lacking;
    const double to_conic = 1 / ((cxx * cyy - cxy * cxy) * support2);
    kernels.conic_xx[i] = static_cast<float>(cyy * to_conic);
    kernels.conic_xy[i] = static_cast<float>(-cxy * to_conic);
    kernels.conic_yy[i] = static_cast<float>(cxx * to_conic);
    kernels.half_width[i] = static_cast<float>(kernel_support * std::sqrt(cxx));
    kernels.half_height[i] = static_cast<float>(kernel_support * std::sqrt(cyy));
    smaller_variance[i] = static_cast<float>(smaller);
  }
}

/// The lens' Jacobian at a row of ideal points, or its inverse.
template <bool inverted>
void jacobians_of_row(const Distortion lens, int count, const double* __restrict x,
                      const double* __restrict y, JacobianRow& __restrict jacobian) {
  for (int i = 0; i < count; ++i) {
    const DistortedPoint at = evaluate(lens, x[i], y[i]);
    const double scale = inverted ? 1 / (at.xx * at.yy - at.xy * at.xy) : 1;
    jacobian.xx[i] = scale * (inverted ? at.yy : at.xx);
    jacobian.xy[i] = scale * (inverted ? -at.xy : at.xy);
    jacobian.yy[i] = scale * (inverted ? at.xx : at.yy);
  }
}

void start(FootprintTile& tile, const TileRect& rect) {
  tile.width = rect.width;
  tile.height = rect.height;
  tile.worst_residual_px = 0;
}

}  // namespace

void distorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile) {
  start(tile, rect);
  InverseMapTile ideal;
  invert_tile(geometry.lens, geometry.box, geometry.output, rect, ideal);
  tile.worst_residual_px = ideal.worst_residual_px;

  const Pinhole& source = geometry.source;
  const KernelScale scale(geometry);
  JacobianRow jacobian;
  for (int row = 0; row < rect.height; ++row) {
    const int first = row * side;
    for (int i = 0; i < rect.width; ++i) {
      tile.x[first + i] = source.fx * ideal.x[first + i] + source.cx;
      tile.y[first + i] = source.fy * ideal.y[first + i] + source.cy;
    }
    jacobians_of_row<true>(geometry.lens, rect.width, &ideal.x[first], &ideal.y[first], jacobian);
    kernels_of_row(scale, jacobian, row, tile);
  }
}

void undistorting_footprints(const ResamplingGeometry& geometry, const TileRect& rect, FootprintTile& tile) {
  start(tile, rect);
  const KernelScale scale(geometry);
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<double, side> x, y;
  JacobianRow jacobian;
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
    jacobians_of_row<false>(geometry.lens, rect.width, x.data(), y.data(), jacobian);
    kernels_of_row(scale, jacobian, row, tile);
  }
}

}  // namespace cps
