#include "distortion/warp/gather.h"

#include <algorithm>
#include <cstring>

#include "distortion/warp/channel_count.h"

namespace cps {
namespace {

constexpr int lanes = PlanarPatch::padding;
using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
constexpr Float8 counting = {0, 1, 2, 3, 4, 5, 6, 7};

Float8 load(const float* values) {
  Float8 vector;
  std::memcpy(&vector, values, sizeof vector);
  return vector;
}

/// (v0 + v4, v1 + v5, v2 + v6, v3 + v7).
Float4 sum_of_halves(Float8 v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
}

/// The sums of four vectors.
Float4 sums_of(Float8 a, Float8 b, Float8 c, Float8 d) {
  const Float4 a4 = sum_of_halves(a), b4 = sum_of_halves(b), c4 = sum_of_halves(c), d4 = sum_of_halves(d);
  const Float4 ab = __builtin_shufflevector(a4, b4, 0, 1, 4, 5) + __builtin_shufflevector(a4, b4, 2, 3, 6, 7);
  const Float4 cd = __builtin_shufflevector(c4, d4, 0, 1, 4, 5) + __builtin_shufflevector(c4, d4, 2, 3, 6, 7);
  return __builtin_shufflevector(ab, cd, 0, 2, 4, 6) + __builtin_shufflevector(ab, cd, 1, 3, 5, 7);
}

/// One pixel of gather_row(). Sums over the bounds, eight columns at a time. On one line of the source the
/// kernel's argument is a quadratic in x; what depends on y alone is computed for eight lines at a time.
template <int channels>
void gather_pixel(const PlanarPatch& patch, const PlacedKernels& at, int i, float* pixel) {
  const int x0 = at.bounds.x0[i], y0 = at.bounds.y0[i];
  const int columns = at.bounds.x1[i] - x0 + 1, lines = at.bounds.y1[i] - y0 + 1;
  const float xx = at.kernels.conic_xx[i], xy = 2 * at.kernels.conic_xy[i], yy = at.kernels.conic_yy[i];
  const float first_x = static_cast<float>(x0 - at.x[i]), first_y = static_cast<float>(y0 - at.y[i]);
  const std::size_t stride = patch.stride, plane = stride * patch.rect.height;
  const float* corner = patch.row(0, y0) + (x0 - patch.rect.x0);

  Float8 weights{}, sums[4]{};
  for (int column = 0; column < columns; column += lanes) {
    const Float8 x = counting + (first_x + column);
    const Float8 on_centre_line = 1 - xx * x * x, per_y = xy * x;
    const float* values = corner + column;
    for (int first = 0; first < lines; first += lanes) {
      const Float8 y = (counting + float(first)) + first_y, by_line = yy * y * y;
      float y_of_line[lanes], by_line_of[lanes];
      std::memcpy(y_of_line, &y, sizeof y);
      std::memcpy(by_line_of, &by_line, sizeof by_line);
      const int count = std::min(lanes, lines - first);
      for (int line = 0; line < count; ++line, values += stride) {
        const Float8 t = on_centre_line - per_y * y_of_line[line] - by_line_of[line];
        const Float8 inside = t > 0 ? t : Float8{};
        const Float8 weight = inside * inside * inside;
        weights += weight;
        for (int channel = 0; channel < channels; ++channel)
          sums[channel] += weight * load(values + channel * plane);
      }
    }
  }
  const Float4 totals = sums_of(sums[0], sums[1], sums[2], channels < 4 ? weights : sums[3]);
  const float weight = channels < 4 ? totals[3] : sums_of(weights, weights, weights, weights)[0];
  const Float4 mean = totals * (1 / weight);
  std::memcpy(pixel, &mean, channels * sizeof(float));
}

template <int channels>
void gather_pixels(const PlanarPatch& patch, const PlacedKernels& row, int count, float* pixels) {
  for (int i = 0; i < count; ++i) {
    if (row.bounds.x0[i] >= 0)
      gather_pixel<channels>(patch, row, i, pixels + i * channels);
    else
      std::fill_n(pixels + i * channels, channels, 0.0f);
  }
}

}  // namespace

void gather_row(const PlanarPatch& patch, const PlacedKernels& row, int count, float* pixels) {
  with_channel_count(patch.channels,
                     [&](auto channels) { gather_pixels<channels>(patch, row, count, pixels); });
}

}  // namespace cps
