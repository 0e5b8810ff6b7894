#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/renderer/handmade.h"

/// Estimates by random numbers, with the error that chance leaves them.
namespace cps {

/// Mean of independent draws, and the variance of that mean, by channel.
struct Estimate {
  Eigen::Array3d mean = Eigen::Array3d::Zero(), variance = Eigen::Array3d::Zero();
};

/// Of `draw(i)` for i < count.
template <class Draw>
Estimate estimate(int count, Draw draw) {
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum;
  for (int i = 0; i < count; ++i) {
    const Eigen::Array3d value = draw(i).template cast<double>();
    sum += value;
    squares += value * value;
  }
  const Eigen::Array3d mean = sum / count;
  return {mean, (squares / count - mean * mean) / (count - 1)};
}

/// Mean radiance of a picture, from pictures of 32 seeds.
inline Estimate mean_over_seeds(const RenderScene& scene, const Camera& camera, RenderOptions options) {
  return estimate(32, [&](int seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    return handmade::mean(render(scene, camera, options));
  });
}

/// How many standard errors lie between an estimate and the expected value, whose own relative error is
/// `tolerance`, in the worst channel. With 32 draws (31 degrees of freedom of Student's t) 5.5 are exceeded
/// by chance once in 200,000 estimates.
inline double standard_errors_off(const Estimate& seen, const Eigen::Array3d& expected, double tolerance) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const double off = std::abs(seen.mean[c] - expected[c]) - tolerance * std::abs(expected[c]);
    if (off > 0) worst = std::max(worst, off / std::sqrt(std::max(seen.variance[c], 0.0)));
  }
  return worst;
}
constexpr double max_standard_errors = 5.5;

}  // namespace cps
