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

  KernelScale(const Pinhole& source, const Pinhole& output, double sigma_px)
      : xx(source.fx / output.fx),
        xy(source.fx / output.fy),
        yx(source.fy / output.fx),
        yy(source.fy / output.fy),
        variance(sigma_px * sigma_px) {}
};

/// Kernels of one row from its Jacobians ∂source plane/∂output plane (symmetric: jxx, jxy, jyy); leaves the
/// smaller eigenvalue of each covariance. Written without branches or calls so that it compiles to vector
/// instructions.
void kernels_of_row(const KernelScale& scale, int count, const double* __restrict jxx,
                    const double* __restrict jxy, const double* __restrict jyy, float* __restrict conic_xx,
                    float* __restrict conic_xy, float* __restrict conic_yy, float* __restrict half_width,
                    float* __restrict half_height, float* __restrict smaller_variance) {
  constexpr double pixel_variance = 1.0 / 12, support2 = kernel_support * kernel_support;
  constexpr double narrowest = narrowest_sigma_px * narrowest_sigma_px;
  for (int i = 0; i < count; ++i) {
    const double axx = scale.xx * jxx[i], axy = scale.xy * jxy[i];
    const double ayx = scale.yx * jxy[i], ayy = scale.yy * jyy[i];
    double cxx = scale.variance * (axx * axx + axy * axy) - pixel_variance;
    double cyy = scale.variance * (ayx * ayx + ayy * ayy) - pixel_variance;
    const double cxy = scale.variance * (axx * ayx + axy * ayy);
    const double half_difference = 0.5 * (cxx - cyy);
    const double smaller = 0.5 * (cxx + cyy) - std::sqrt(half_difference * half_difference + cxy * cxy);
    const double lacking = narrowest - smaller > 0 ? narrowest - smaller : 0;
    cxx += lacking;
    cyy += lacking;
    const double to_conic = 1 / ((cxx * cyy - cxy * cxy) * support2);
    conic_xx[i] = static_cast<float>(cyy * to_conic);
    conic_xy[i] = static_cast<float>(-cxy * to_conic);
    conic_yy[i] = static_cast<float>(cxx * to_conic);
    half_width[i] = static_cast<float>(kernel_support * std::sqrt(cxx));
    half_height[i] = static_cast<float>(kernel_support * std::sqrt(cyy));
    smaller_variance[i] = static_cast<float>(smaller);
  }
}

/// The lens' Jacobian at a row of ideal points, or its inverse.
template <bool inverted>
void jacobians_of_row(const Distortion& lens, int count, const double* __restrict x,
                      const double* __restrict y, double* __restrict jxx, double* __restrict jxy,
                      double* __restrict jyy) {
  const double k1 = lens.k1, k2 = lens.k2, k3 = lens.k3, p1 = lens.p1, p2 = lens.p2;
  for (int i = 0; i < count; ++i) {
    const double u = x[i], v = y[i], s = u * u + v * v;
    const double diagonal = 1 + s * (k1 + s * (k2 + s * k3)) + 2 * (p2 * u + p1 * v);
    const double slope = 2 * (k1 + s * (2 * k2 + s * 3 * k3));
    const double xx = diagonal + u * (slope * u + 4 * p2), yy = diagonal + v * (slope * v + 4 * p1);
    const double xy = slope * u * v + 2 * (p2 * v + p1 * u);
    const double scale = inverted ? 1 / (xx * yy - xy * xy) : 1;
    jxx[i] = scale * (inverted ? yy : xx);
    jxy[i] = scale * (inverted ? -xy : xy);
    jyy[i] = scale * (inverted ? xx : yy);
  }
}

struct JacobianRow {
  alignas(32) std::array<double, side> xx, xy, yy;
};

void kernels_at(const KernelScale& scale, int row, const JacobianRow& jacobian, FootprintTile& tile) {
  const int first = row * side;
  kernels_of_row(scale, tile.width, jacobian.xx.data(), jacobian.xy.data(), jacobian.yy.data(),
                 &tile.conic_xx[first], &tile.conic_xy[first], &tile.conic_yy[first], &tile.half_width[first],
                 &tile.half_height[first], &tile.smaller_variance[first]);
}

void start(FootprintTile& tile, int width, int height) {
  tile.width = width;
  tile.height = height;
  tile.worst_residual_px = 0;
  tile.fallbacks = 0;
  tile.weighted = false;
}

}  // namespace

void distorting_footprints(const Distortion& lens, const Eigen::AlignedBox2d& box, const Pinhole& source,
                           const Pinhole& output, double sigma_px, int x0, int y0, int width, int height,
                           FootprintTile& tile) {
  start(tile, width, height);
  InverseMapTile ideal;
  invert_tile(lens, box, output, x0, y0, width, height, ideal);
  tile.worst_residual_px = ideal.worst_residual_px;
  tile.fallbacks = ideal.fallbacks;

  const KernelScale scale(source, output, sigma_px);
  JacobianRow jacobian;
  for (int row = 0; row < height; ++row) {
    const int first = row * side;
    for (int i = 0; i < width; ++i) {
      tile.x[first + i] = source.fx * ideal.x[first + i] + source.cx;
      tile.y[first + i] = source.fy * ideal.y[first + i] + source.cy;
    }
    jacobians_of_row<true>(lens, width, &ideal.x[first], &ideal.y[first], jacobian.xx.data(),
                           jacobian.xy.data(), jacobian.yy.data());
    kernels_at(scale, row, jacobian, tile);
  }
}

void undistorting_footprints(const Distortion& lens, const Eigen::AlignedBox2d& box, const Pinhole& source,
                             const Pinhole& output, double sigma_px, int x0, int y0, int width, int height,
                             FootprintTile& tile) {
  start(tile, width, height);
  const KernelScale scale(source, output, sigma_px);
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<double, side> x, y;
  JacobianRow jacobian;
  for (int row = 0; row < height; ++row) {
    const int first = row * side;
    for (int i = 0; i < width; ++i) {
      const Eigen::Vector2d ideal = to_plane(output, {x0 + i, y0 + row});
      const Eigen::Vector2d position = box.contains(ideal) ? to_pixel(source, distort(lens, ideal)) : nowhere;
      x[i] = ideal.x();
      y[i] = ideal.y();
      tile.x[first + i] = position.x();
      tile.y[first + i] = position.y();
    }
    jacobians_of_row<false>(lens, width, x.data(), y.data(), jacobian.xx.data(), jacobian.xy.data(),
                            jacobian.yy.data());
    kernels_at(scale, row, jacobian, tile);
  }
}

}  // namespace cps
