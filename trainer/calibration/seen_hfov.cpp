#include "trainer/calibration/seen_hfov.h"

#include <algorithm>
#include <cmath>

namespace cps {
namespace {

double distorted_radius(const Outputs& lens, double r) {
  const double s = r * r;
  return r * (1 + s * (lens[1] + s * (lens[2] + s * lens[3])));
}

double radial_slope(const Outputs& lens, double r) {
  const double s = r * r;
  return 1 + s * (3 * lens[1] + s * (5 * lens[2] + s * 7 * lens[3]));
}

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
  constexpr int steps = 128;
  constexpr double max_stretch = 4;
  const double step = max_stretch * distorted / steps;
  for (int i = 0; i < steps; ++i) {
    const double low = i * step, high = low + step;
    const double end = radial_slope(lens, high) > 0
                           ? high
                           : border(low, high, [&](double r) { return radial_slope(lens, r) > 0; });
    if (distorted_radius(lens, end) >= distorted) {
      const double r = border(low, end, [&](double at) { return distorted_radius(lens, at) < distorted; });
      return {r, std::max(0.0, radial_slope(lens, r))};
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
