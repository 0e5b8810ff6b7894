#pragma once

#include <catch2/catch.hpp>

#include "distortion/inverse/inverse.h"
#include "distortion/warp/footprints.h"
#include "tests/distortion/warp/analytic_scene.h"

namespace cps {

/// The value that the warp approximates: a kernel-weighted mean over rays through a dense grid around the
/// output pixel.
inline double reference_pixel(const AnalyticScene& scene, const Distortion& lens,
                              const Eigen::AlignedBox2d& box, const Pinhole& output, double sigma_px,
                              const Eigen::Vector2d& pixel, int steps) {
  double sum = 0, weights = 0;
  for (int j = 0; j < steps; ++j)
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d offset =
          kernel_support * sigma_px * (Eigen::Vector2d(2 * i + 1, 2 * j + 1) / steps - Eigen::Vector2d(1, 1));
      const double t = 1 - offset.squaredNorm() / (kernel_support * kernel_support * sigma_px * sigma_px);
      if (t <= 0) continue;
      const auto ideal = undistort(lens, box, to_plane(output, pixel + offset));
      REQUIRE(ideal);
      sum += t * t * t * scene(*ideal);
      weights += t * t * t;
    }
  return sum / weights;
}

}  // namespace cps
