#include "distortion/inverse/iterative_inverses.h"

#include <Eigen/LU>

namespace cps {
namespace {

/// Applies `next` until x stops changing, is no longer finite, or `steps` steps are done.
template <typename Next>
Eigen::Vector2d iterate(const Eigen::Vector2d& start, int steps, Next next) {
  Eigen::Vector2d x = start;
  for (int step = 0; step < steps && x.allFinite(); ++step) {
    const Eigen::Vector2d before = x;
    x = next(x);
    if (x == before) break;
  }
  return x;
}

}  // namespace

Eigen::Vector2d undistort_by_fixed_point(const Distortion& lens, const Eigen::Vector2d& distorted,
                                         int steps) {
  return iterate(distorted, steps, [&](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return x + (distorted - distort(lens, x));
  });
}

Eigen::Vector2d undistort_by_ratio(const Distortion& lens, const Eigen::Vector2d& distorted, int steps) {
  bool given_up = false;
  const Eigen::Vector2d found = iterate(distorted, steps, [&](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    const double s = x.squaredNorm(), radial = 1 + s * (lens.k1 + s * (lens.k2 + s * lens.k3));
    given_up = given_up || radial < 0;
    if (given_up) return x;
    const Eigen::Vector2d tangential = distort({.p1 = lens.p1, .p2 = lens.p2}, x) - x;
    return (distorted - tangential) / radial;
  });
  return given_up ? distorted : found;
}

Eigen::Vector2d undistort_by_newton(const Distortion& lens, const Eigen::Vector2d& distorted, int steps) {
  return iterate(distorted, steps, [&](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return x - distortion_jacobian(lens, x).inverse() * (distort(lens, x) - distorted);
  });
}

}  // namespace cps
