#include "distortion/warp/point_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace cps {
namespace {

/// Where 1/z differs by more than this share between four neighbours, an edge is assumed among them.
constexpr double max_relative_step = 0.05;

struct Position {
  int x, y;     ///< nearest pixel
  double u, v;  ///< exact, pixels
};

double depth_at(const OIIO::ImageBuf& source, const Position& at, int channel) {
  const OIIO::ImageSpec& spec = source.spec();
  const auto inverse = [&](int x, int y) {
    return 1.0 / source.getchannel(spec.x + x, spec.y + y, 0, channel);
  };
  const int left = std::clamp(int(std::floor(at.u)), 0, std::max(0, spec.width - 2));
  const int top = std::clamp(int(std::floor(at.v)), 0, std::max(0, spec.height - 2));
  const int right = std::min(left + 1, spec.width - 1), bottom = std::min(top + 1, spec.height - 1);
  const double a = inverse(left, top), b = inverse(right, top), c = inverse(left, bottom),
               d = inverse(right, bottom);
  const auto [min, max] = std::minmax({a, b, c, d});
  // An infinite 1/z is a depth of 0: nothing was measured there.
  if (!(max - min <= max_relative_step * max) || std::isinf(max)) return 1 / inverse(at.x, at.y);
  const double fx = std::clamp(at.u - left, 0.0, 1.0), fy = std::clamp(at.v - top, 0.0, 1.0);
  return 1 / ((1 - fy) * ((1 - fx) * a + fx * b) + fy * ((1 - fx) * c + fx * d));
}

}  // namespace

int sample_tile(const OIIO::ImageBuf& source, const FootprintTile& tile, Resampling resampling, int x0,
                int y0, OIIO::ImageBuf& output) {
  const OIIO::ImageSpec& spec = source.spec();
  int missed = 0;
  for (int row = 0; row < tile.height; ++row)
    for (int column = 0; column < tile.width; ++column) {
      const int index = row * FootprintTile::side + column;
      void* pixel = output.pixeladdr(x0 + column, y0 + row);
      const double u = tile.x[index], v = tile.y[index];
      if (!(u >= -0.5 && v >= -0.5 && u < spec.width - 0.5 && v < spec.height - 0.5)) {
        std::memset(pixel, 0, spec.pixel_bytes());
        ++missed;
        continue;
      }
      const Position at{int(std::floor(u + 0.5)), int(std::floor(v + 0.5)), u, v};
      if (resampling == Resampling::nearest) {
        std::memcpy(pixel, source.pixeladdr(spec.x + at.x, spec.y + at.y), spec.pixel_bytes());
        continue;
      }
      std::array<float, 4> depth;
      for (int channel = 0; channel < spec.nchannels; ++channel)
        depth[channel] = float(depth_at(source, at, channel));
      OIIO::convert_pixel_values(OIIO::TypeFloat, depth.data(), spec.format, pixel, spec.nchannels);
    }
  return missed;
}

}  // namespace cps
