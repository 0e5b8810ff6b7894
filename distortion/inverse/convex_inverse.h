#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cps {

/// Exact minimiser of g·p + ½ pᵀHp over low ≤ p ≤ high, H positive definite.
[[gnu::always_inline]] inline Eigen::Vector2d minimiser_in_box(const Eigen::Matrix2d& H,
                                                               const Eigen::Vector2d& g,
                                                               const Eigen::Vector2d& low,
                                                               const Eigen::Vector2d& high) {
  const double det = H(0, 0) * H(1, 1) - H(0, 1) * H(0, 1);
  const Eigen::Vector2d newton(-(H(1, 1) * g.x() - H(0, 1) * g.y()) / det,
                               -(H(0, 0) * g.y() - H(0, 1) * g.x()) / det);
  if ((newton.array() >= low.array()).all() && (newton.array() <= high.array()).all()) return newton;

  // Not inside: the minimiser lies on one of the four sides.
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double smallest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis)
    for (const double fixed : {low[axis], high[axis]}) {
      const int free = 1 - axis;
      Eigen::Vector2d p;
      p[axis] = fixed;
      p[free] = std::min(std::max(-(g[free] + H(0, 1) * fixed) / H(free, free), low[free]), high[free]);
      if (const double model = p.dot(g + 0.5 * (H * p)); model < smallest) smallest = model, best = p;
    }
  return best;
}

/// Step length t along p at which the slope (D(x + t p) − target)·p, which grows with t from `slope0` < 0 at
/// t = 0, is nearly zero; at most 1.
template <typename Lens>
[[gnu::always_inline]] inline double line_search(const Lens& lens, const Eigen::Vector2d& x,
                                                 const Eigen::Vector2d& p, const Eigen::Vector2d& target,
                                                 double slope0) {
  double low = 0, high = 1, slope_low = slope0;
  double slope_high = (distort(lens, x + p) - target).dot(p);
  if (slope_high <= -0.1 * slope0) return 1;
  for (int i = 0; i < 60; ++i) {
    const double secant = low + (high - low) * slope_low / (slope_low - slope_high);
    const double t = std::min(std::max(secant, low + 0.1 * (high - low)), high - 0.1 * (high - low));
    const double slope = (distort(lens, x + t * p) - target).dot(p);
    if (std::abs(slope) <= -0.1 * slope0) return t;
    if (slope < 0)
      low = t, slope_low = slope;
    else
      high = t, slope_high = slope;
  }
  return low;
}

/// undistort() (inverse.h) for any lens of a plane that is the gradient of a function which is strictly
/// convex on the box: a type with distort(lens, ideal) and distortion_jacobian(lens, ideal). Always inlined,
/// its evaluations too, so that each family has code of its own.
template <typename Lens>
[[gnu::always_inline]] inline std::optional<Eigen::Vector2d> convex_inverse(
    const Lens& lens, const Eigen::AlignedBox2d& box, const Eigen::Vector2d& distorted) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double size = 1 + distorted.cwiseAbs().maxCoeff();
  Eigen::Vector2d x = distorted.cwiseMax(box.min()).cwiseMin(box.max());
  Eigen::Vector2d gradient = distort(lens, x) - distorted;
  for (int iteration = 0; iteration < 100 && gradient.cwiseAbs().maxCoeff() > epsilon * size; ++iteration) {
    const Eigen::Vector2d step =
        minimiser_in_box(distortion_jacobian(lens, x), gradient, box.min() - x, box.max() - x);
    const double slope = gradient.dot(step);
    if (!(slope < 0) || step.cwiseAbs().maxCoeff() <= epsilon * x.cwiseAbs().maxCoeff()) break;
    x += line_search(lens, x, step, distorted, slope) * step;
    gradient = distort(lens, x) - distorted;
  }
  constexpr double inside = 1e-12;
  const double residual = gradient.cwiseAbs().maxCoeff();
  if (residual < inside * size) return x;
  // Where the lens enlarges much, four roundings of the ideal point move its image by more than that.
  const double enlarged = (distortion_jacobian(lens, x).cwiseAbs() * x.cwiseAbs()).maxCoeff();
  if (!(residual < 4 * epsilon * enlarged)) return std::nullopt;  // infinite targets too
  return x;
}

}  // namespace cps
