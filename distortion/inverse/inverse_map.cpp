#include "distortion/inverse/inverse_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "distortion/inverse/inverse.h"

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

/// The distorted points (xd[i], yd) of one row of pixels, which the functions below invert. Their loops have
/// no branches or calls, so that they compile to vector instructions.
struct TargetRow {
  int count;
  const double* xd;
  double yd;
};

/// One Newton step for each target, from the ideal points (x[i], y[i]).
void newton_step(const Distortion lens, const TargetRow& target, double* __restrict x, double* __restrict y) {
  const double yd = target.yd;
  const double* __restrict xd = target.xd;
  for (int i = 0; i < target.count; ++i) {
    const DistortedPoint at = evaluate(lens, x[i], y[i]);
    const double error_x = at.x - xd[i], error_y = at.y - yd;
    const double scale = 1 / (at.xx * at.yy - at.xy * at.xy);
    x[i] = x[i] - scale * (at.yy * error_x - at.xy * error_y);
    y[i] = y[i] - scale * (at.xx * error_y - at.xy * error_x);
  }
}

/// residual[i] = |D(x) − target|, infinite where x lies outside the box.
void measure(const Distortion lens, const Eigen::AlignedBox2d& box, const TargetRow& target,
             const double* __restrict x, const double* __restrict y, double* __restrict residual) {
  const double yd = target.yd;
  const double left = box.min().x(), right = box.max().x(), top = box.min().y(), bottom = box.max().y();
  const double* __restrict xd = target.xd;
  for (int i = 0; i < target.count; ++i) {
    const DistortedPoint at = evaluate(lens, x[i], y[i]);
    const double error_x = at.x - xd[i], error_y = at.y - yd;
    const bool inside = (x[i] >= left) & (x[i] <= right) & (y[i] >= top) & (y[i] <= bottom);
    residual[i] =
        inside ? std::sqrt(error_x * error_x + error_y * error_y) : std::numeric_limits<double>::infinity();
  }
}

/// Number of residuals above `enough`.
int count_failed(int count, const double* __restrict residual, double enough) {
  int failed = 0;
  for (int i = 0; i < count; ++i) failed += residual[i] <= enough ? 0 : 1;
  return failed;
}

}  // namespace

void invert_tile(const Distortion& lens, const Eigen::AlignedBox2d& box, const Pinhole& camera,
                 const TileRect& rect, InverseMapTile& tile) {
  const auto [x0, y0, width, height] = rect;
  tile.width = width;
  tile.height = height;
  tile.outside = tile.fallbacks = 0;

  const Interpolation across(width), down(height);
  std::array<std::array<Eigen::Vector2d, nodes>, nodes> node;
  for (int j = 0; j < nodes; ++j)
    for (int i = 0; i < nodes; ++i) {
      const Eigen::Vector2d target = to_plane(camera, {x0 + across.position[i], y0 + down.position[j]});
      // A node outside D(box) only makes the guess worse, not the result.
      node[j][i] = undistort(lens, box, target).value_or(target);
    }

  Row xd, residual;
  for (int i = 0; i < width; ++i) xd[i] = to_plane(camera, {x0 + i, 0}).x();
  const double pixels = std::max(camera.fx, camera.fy), enough = 1e-9 / pixels;
  Row worst{};
  for (int row = 0; row < height; ++row) {
    double* x = &tile.x[row * side];
    double* y = &tile.y[row * side];
    std::array<Eigen::Vector2d, nodes> at_row;
    for (int i = 0; i < nodes; ++i) {
      at_row[i].setZero();
      for (int j = 0; j < nodes; ++j) at_row[i] += down.weight[j][row] * node[j][i];
    }
    for (int column = 0; column < width; ++column) {
      double sum_x = 0, sum_y = 0;
      for (int i = 0; i < nodes; ++i) {
        sum_x += across.weight[i][column] * at_row[i].x();
        sum_y += across.weight[i][column] * at_row[i].y();
      }
      x[column] = sum_x;
      y[column] = sum_y;
    }

    const TargetRow target{width, xd.data(), to_plane(camera, {0, y0 + row}).y()};
    int failed = width;
    for (int step = 0; step < 3 && failed > 0; ++step) {
      newton_step(lens, target, x, y);
      measure(lens, box, target, x, y, residual.data());
      failed = count_failed(width, residual.data(), enough);
    }
    for (int column = 0; column < width && failed > 0; ++column) {
      if (residual[column] <= enough) continue;
      ++tile.fallbacks;
      --failed;
      const Eigen::Vector2d distorted(xd[column], target.yd);
      const auto ideal = undistort(lens, box, distorted);
      tile.outside += !ideal;
      x[column] = ideal ? ideal->x() : std::numeric_limits<double>::quiet_NaN();
      y[column] = ideal ? ideal->y() : std::numeric_limits<double>::quiet_NaN();
      residual[column] = ideal ? (distort(lens, *ideal) - distorted).norm() : 0;
    }
    for (int column = 0; column < width; ++column) worst[column] = std::max(worst[column], residual[column]);
  }
  tile.worst_residual_px = *std::max_element(worst.begin(), worst.begin() + width) * pixels;
}

}  // namespace cps
