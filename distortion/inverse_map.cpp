#include "distortion/inverse_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "distortion/inverse.h"

namespace cps {
namespace {

constexpr int side = InverseMapTile::side;
constexpr int nodes = 5;
using Row = std::array<double, side>;

/// Chebyshev nodes of [0, last] and the Lagrange basis at 0, 1, …, last.
struct Interpolation {
  std::array<double, nodes> position;
  std::array<Row, nodes> weight;

  explicit Interpolation(int count) {
    const double half = 0.5 * (count - 1);
    for (int j = 0; j < nodes; ++j)
      position[j] = half - half * std::cos((j + 0.5) * std::numbers::pi / nodes);
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < count; ++i) {
        double basis = 1;
        for (int k = 0; k < nodes; ++k)
          if (k != j && half > 0) basis *= (i - position[k]) / (position[j] - position[k]);
        weight[j][i] = half > 0 ? basis : 1.0 / nodes;
      }
  }
};

/// Two Newton steps for one row of targets (xd[i], yd); leaves the residual in units of the plane. Written
/// without branches or calls so that it compiles to vector instructions.
void newton_row(const Distortion& lens, int count, const double* __restrict xd, double yd,
                double* __restrict x, double* __restrict y, double* __restrict residual) {
  const double k1 = lens.k1, k2 = lens.k2, k3 = lens.k3, p1 = lens.p1, p2 = lens.p2;
  for (int i = 0; i < count; ++i) {
    double u = x[i], v = y[i], error_u = 0, error_v = 0;
#pragma GCC unroll 3
    for (int step = 0; step < 3; ++step) {
      const double s = u * u + v * v;
      const double radial = 1 + s * (k1 + s * (k2 + s * k3)), pull = 2 * (p2 * u + p1 * v);
      error_u = u * (radial + pull) + p2 * s - xd[i];
      error_v = v * (radial + pull) + p1 * s - yd;
      if (step == 2) break;  // the last pass only measures
      const double slope = 2 * (k1 + s * (2 * k2 + s * 3 * k3));
      const double xx = radial + pull + u * (slope * u + 4 * p2),
                   yy = radial + pull + v * (slope * v + 4 * p1);
      const double xy = slope * u * v + 2 * (p2 * v + p1 * u);
      const double scale = 1 / (xx * yy - xy * xy);
      u -= scale * (yy * error_u - xy * error_v);
      v -= scale * (xx * error_v - xy * error_u);
    }
    x[i] = u;
    y[i] = v;
    residual[i] = std::sqrt(error_u * error_u + error_v * error_v);
  }
}

}  // namespace

void invert_tile(const Distortion& lens, const Eigen::AlignedBox2d& box, const Pinhole& camera, int x0,
                 int y0, int width, int height, InverseMapTile& tile) {
  tile.width = width;
  tile.height = height;
  tile.worst_residual_px = 0;
  tile.outside = tile.fallbacks = 0;

  const Interpolation across(width), down(height);
  std::array<std::array<Eigen::Vector2d, nodes>, nodes> node;
  for (int j = 0; j < nodes; ++j)
    for (int i = 0; i < nodes; ++i) {
      const Eigen::Vector2d target = to_plane(camera, {x0 + across.position[i], y0 + down.position[j]});
      // A node outside D(box) spoils the guess, not the result.
      node[j][i] = undistort(lens, box, target).value_or(target);
    }

  Row xd, residual;
  for (int i = 0; i < width; ++i) xd[i] = to_plane(camera, {x0 + i, 0}).x();
  const double pixels = std::max(camera.fx, camera.fy);
  constexpr double enough_px = 1e-9;
  for (int row = 0; row < height; ++row) {
    double* x = &tile.x[row * side];
    double* y = &tile.y[row * side];
    std::fill_n(x, width, 0.0);
    std::fill_n(y, width, 0.0);
    for (int i = 0; i < nodes; ++i) {
      Eigen::Vector2d at_row = Eigen::Vector2d::Zero();
      for (int j = 0; j < nodes; ++j) at_row += down.weight[j][row] * node[j][i];
      const double node_x = at_row.x(), node_y = at_row.y();
      const double* weight = across.weight[i].data();
      for (int column = 0; column < width; ++column) {
        x[column] += weight[column] * node_x;
        y[column] += weight[column] * node_y;
      }
    }
    const double yd = to_plane(camera, {0, y0 + row}).y();
    newton_row(lens, width, xd.data(), yd, x, y, residual.data());

    for (int column = 0; column < width; ++column) {
      double residual_px = residual[column] * pixels;
      const bool inside = box.contains(Eigen::Vector2d(x[column], y[column]));
      if (!(residual_px <= enough_px && inside)) {
        ++tile.fallbacks;
        const Eigen::Vector2d target(xd[column], yd);
        const auto ideal = undistort(lens, box, target);
        if (!ideal) {
          ++tile.outside;
          x[column] = y[column] = std::numeric_limits<double>::quiet_NaN();
          continue;
        }
        x[column] = ideal->x();
        y[column] = ideal->y();
        residual_px = (distort(lens, *ideal) - target).norm() * pixels;
      }
      tile.worst_residual_px = std::max(tile.worst_residual_px, residual_px);
    }
  }
}

}  // namespace cps
