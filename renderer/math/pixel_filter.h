#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "renderer/math/fast_math.h"

namespace cps {

/// How a pixel weighs the light around its centre. Rays are drawn with this density, so that all count the
/// same.
enum class PixelFilter {
  box,      ///< the pixel's own square: what warping a master assumes
  tent,     ///< falls linearly to 0 over one pixel on each axis
  gaussian  ///< standard deviation half a pixel, cut off at one and a half
};

/// Half width of the filter on each axis, pixels.
constexpr float filter_radius_px(PixelFilter filter) {
  switch (filter) {
    case PixelFilter::box:
      return 0.5f;
    case PixelFilter::tent:
      return 1.0f;
    case PixelFilter::gaussian:
      return 1.5f;
  }
  return 0.5f;
}

/// Offset of a ray from the pixel's centre, pixels, for `u` uniform in [0, 1)².
inline Eigen::Vector2f sample_filter(PixelFilter filter, const Eigen::Vector2f& u) {
  const auto tent = [](float v) {
    const float side = 2.0f * v - 1.0f;
    return std::copysign(1.0f - std::sqrt(1.0f - std::abs(side)), side);
  };
  switch (filter) {
    case PixelFilter::box:
      return u - Eigen::Vector2f::Constant(0.5f);
    case PixelFilter::tent:
      return {tent(u.x()), tent(u.y())};
    case PixelFilter::gaussian: {
      // Box & Muller 1958. The radius is cut off where the distribution has reached 1 − exp(−3²/2).
      constexpr float sigma_px = 0.5f, within = 0.98889100f, ln2 = 0.69314718f;
      const float radius = sigma_px * std::sqrt(std::max(0.0f, -2.0f * ln2 * log2_of(1.0f - within * u.x())));
      const SinCos angle = sincos_of_turns(u.y());
      return {radius * angle.cos, radius * angle.sin};
    }
  }
  return Eigen::Vector2f::Zero();
}

}  // namespace cps
