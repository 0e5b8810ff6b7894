#include "trainer/calibration/seen_hfov.h"

#include <algorithm>
#include <cmath>

#include "distortion/brown_conrady.h"

namespace cps {
namespace {

/// Halves [low, high] until it cannot be halved; `is_low` holds at low and not at high.
template <typename IsLow>
double border(double low, double high, IsLow is_low) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (is_low(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

IdealRadius ideal_radius(const Outputs& lens, double distorted) {
  const Distortion radial{lens[1], lens[2], lens[3]};
  const auto distorted_radius = [&](double r) { return evaluate(radial, r, 0).x; };
  const auto slope = [&](double r) { return evaluate(radial, r, 0).xx; };
  constexpr int steps = 128;
  constexpr double max_stretch = 4;
  const double step = max_stretch * distorted / steps;
  for (int i = 0; i < steps; ++i) {
    const double low = i * step, high = low + step;
    const double end = slope(high) > 0 ? high : border(low, high, [&](double r) { return slope(r) > 0; });
    if (distorted_radius(end) >= distorted) {
      const double r = border(low, end, [&](double at) { return distorted_radius(at) < distorted; });
      return {r, std::max(0.0, slope(r))};
    }
    if (end < high) return {end, 0};
  }
  return {max_stretch * distorted, 0};
}

double half_width_share(int width, int height) {
  return width / std::hypot(width, height);
}

double seen_from_label_fov(const Outputs& apparent, int width, int height) {
  const double share = half_width_share(width, height);
  return 2 * std::atan(std::tan(apparent[0] / 2) / share * ideal_radius(apparent, share).radius);
}

double label_from_seen_fov(const Outputs& seen, int width, int height) {
  const double share = half_width_share(width, height);
  return 2 * std::atan(std::tan(seen[0] / 2) * share / ideal_radius(seen, share).radius);
}

}  // namespace cps
