#include "distortion/inverse/inverse.h"

#include <Eigen/LU>

#include "distortion/inverse/convex_inverse.h"

namespace cps {

std::optional<Eigen::Vector2d> undistort(const Distortion& lens, const Eigen::AlignedBox2d& box,
                                         const Eigen::Vector2d& distorted) {
  return convex_inverse(lens, box, distorted);
}

std::optional<Eigen::Vector2d> undistort_near(const Distortion& lens, const Eigen::AlignedBox2d& box,
                                              const Eigen::Vector2d& distorted,
                                              const Eigen::Vector2d& guess) {
  constexpr int max_steps = 4;
  const double enough = 1e-14 * (1 + distorted.cwiseAbs().maxCoeff());
  Eigen::Vector2d x = guess;
  for (int step = 0; step < max_steps; ++step) {
    const Eigen::Vector2d error = distort(lens, x) - distorted;
    if (error.cwiseAbs().maxCoeff() <= enough && box.contains(x)) return x;
    x -= distortion_jacobian(lens, x).inverse() * error;
  }
  return undistort(lens, box, distorted);
}

}  // namespace cps
