#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "distortion/warp/warp.h"
#include "tests/distortion/warp/analytic_scene.h"

using namespace cps;

namespace {

/// Frequency (cycles per pixel) at which the contrast of a nearly vertical edge of slope dx/dy has fallen to
/// one half (ISO 12233's method: project on the edge's normal, oversample, differentiate, transform).
double mtf50(const OIIO::ImageBuf& image, double edge_x_at_0, double slope) {
  constexpr int bins_per_px = 8, half_width = 10, count = 2 * half_width * bins_per_px;
  std::vector<double> sums(count, 0), weights(count, 0);
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  for (int y = 0; y < image.spec().height; ++y)
    for (int x = 0; x < image.spec().width; ++x) {
      const double distance = (x - edge_x_at_0 - slope * y) * cosine;
      const int bin = int(std::floor((distance + half_width) * bins_per_px));
      if (bin < 0 || bin >= count) continue;
      sums[bin] += image.getchannel(x, y, 0, 0);
      weights[bin] += 1;
    }
  for (int i = 0; i < count; ++i) {
    REQUIRE(weights[i] > 0);
    sums[i] /= weights[i];
  }
  const auto contrast = [&](double frequency) {
    double re = 0, im = 0;
    for (int i = 1; i < count; ++i) {
      const double slope_here = sums[i] - sums[i - 1],
                   phase = 2 * std::numbers::pi * frequency * i / bins_per_px;
      re += slope_here * std::cos(phase);
      im += slope_here * std::sin(phase);
    }
    // Undo the averaging over a bin and the finite difference: both are box filters one bin wide.
    const double argument = std::numbers::pi * frequency / bins_per_px;
    const double box = argument > 0 ? std::sin(argument) / argument : 1;
    return std::hypot(re, im) / (box * box);
  };
  double low = 0, high = 1;
  const double at_zero = contrast(0);
  while (high - low > 1e-5) {
    const double middle = 0.5 * (low + high);
    (contrast(middle) > 0.5 * at_zero ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("sharpness does not follow the local magnification") {
  const WarpOptions options;
  std::vector<double> found;
  std::string table;
  for (const double scale : {0.6, 0.8, 1.0, 1.3, 1.7}) {
    // The output has `scale` times the base's pixels per unit of the plane; the master stays the same.
    const Pinhole output{64, 200, 100 * scale, 100 * scale, 32, 100};
    const Pinhole base{240, 480, 100, 100, 120, 240};
    const Pinhole master = oversampled(base, options.oversampling);
    const double slope = 0.0875, edge = 0.013;
    const auto image = warp(
        render_analytic([&](const Eigen::Vector2d& p) { return p.x() > edge + slope * p.y() ? 1.f : 0.f; },
                        master, 16),
        master, {}, output, options);
    const double edge_px = output.cx + output.fx * edge - slope * output.cy;
    found.push_back(mtf50(image, edge_px, slope));
    table.append(" ").append(std::to_string(scale)).append(": ").append(std::to_string(found.back()));
  }
  const auto [least, most] = std::minmax_element(found.begin(), found.end());
  INFO("MTF50, cycles per pixel, by local scale:" << table);
  CHECK(*most / *least < 1.03);
}
