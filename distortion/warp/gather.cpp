#include "distortion/warp/gather.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
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

Float8 positive_part(Float8 v) {
  return _mm256_max_ps(v, Float8{});
}

/// The sums of four vectors, in lanes 0, 4, 2 and 6.
Float8 sums_of(Float8 a, Float8 b, Float8 c, Float8 d) {
  const Float8 ab = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11) +
                    __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
  const Float8 cd = __builtin_shufflevector(c, d, 0, 1, 2, 3, 8, 9, 10, 11) +
                    __builtin_shufflevector(c, d, 4, 5, 6, 7, 12, 13, 14, 15);
  const Float8 abcd = __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13) +
                      __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15);
  return abcd + __builtin_shufflevector(abcd, abcd, 1, 0, 3, 2, 5, 4, 7, 6);
}

/// What gather_row() reads of a patch.
struct Planes {
  const float* values;
  std::size_t stride, plane;  ///< from line to line, from channel to channel
};

/// Where each pixel's sums begin, how far that is from the kernel's centre, and how far they go; no columns
/// where nothing is to be gathered.
struct Blocks {
  alignas(32) std::array<int, KernelRow::side> offset, columns, lines;
  alignas(32) std::array<float, KernelRow::side> x, y;

  Blocks(const PlanarPatch& patch, const PlacedKernels& row, int count) {
    const BoundsRow& bounds = row.bounds;
    const int stride = int(patch.stride), corner = -patch.rect.y0 * stride - patch.rect.x0;
    for (int i = 0; i < count; ++i) {
      const int x0 = bounds.x0[i], y0 = bounds.y0[i];
      offset[i] = y0 * stride + x0 + corner;
      columns[i] = x0 >= 0 ? bounds.x1[i] - x0 + 1 : 0;
      lines[i] = bounds.y1[i] - y0 + 1;
      x[i] = static_cast<float>(x0 - row.x[i]);
      y[i] = static_cast<float>(y0 - row.y[i]);
    }
  }
};

template <int channels>
struct Sums {
  Float8 weights{}, values[4]{};

  /// Adds eight columns of up to eight lines, which begin at (x, y) from the kernel's centre. On one line the
  /// kernel's argument is a quadratic in x.
  [[gnu::always_inline]] void add(const Planes& source, const float* values_at, int lines, float x, float y,
                                  float xx, float xy, float yy) {
    const Float8 xs = counting + x, ys = counting + y;
    const Float8 on_centre_line = 1 - xx * xs * xs, per_y = xy * xs, by_line = yy * ys * ys;
    float y_of_line[lanes], by_line_of[lanes];
    std::memcpy(y_of_line, &ys, sizeof ys);
    std::memcpy(by_line_of, &by_line, sizeof by_line);
#pragma GCC unroll 1
    for (int line = 0; line < lines; ++line, values_at += source.stride) {
      const Float8 inside = positive_part(on_centre_line - per_y * y_of_line[line] - by_line_of[line]);
      const Float8 weight = inside * inside * inside;
      weights += weight;
      for (int channel = 0; channel < channels; ++channel)
        values[channel] += weight * load(values_at + channel * source.plane);
    }
  }

  Float4 mean() const {
    const Float8 totals = sums_of(values[0], values[1], values[2], channels < 4 ? weights : values[3]);
    const float weight = channels < 4 ? totals[6] : sums_of(weights, weights, weights, weights)[0];
    return __builtin_shufflevector(totals, totals, 0, 4, 2, 6) * (1 / weight);
  }
};

/// Calls use(i, mean) for each pixel of which something is to be gathered, and skip(i) for the others.
template <int channels, typename Use, typename Skip>
void gather_pixels(const Planes source, const Blocks& blocks, const KernelRow& kernels, int count,
                   const Use& use, const Skip& skip) {
  for (int i = 0; i < count; ++i) {
    const int columns = blocks.columns[i], lines = blocks.lines[i];
    if (columns == 0) {
      skip(i);
      continue;
    }
    const float xx = kernels.conic_xx[i], xy = 2 * kernels.conic_xy[i], yy = kernels.conic_yy[i];
    const float x = blocks.x[i], y = blocks.y[i];
    const float* corner = source.values + blocks.offset[i];
    Sums<channels> sums;
    if (columns <= lanes && lines <= lanes) {
      sums.add(source, corner, lines, x, y, xx, xy, yy);
    } else {
      for (int column = 0; column < columns; column += lanes)
        for (int line = 0; line < lines; line += lanes)
          sums.add(source, corner + column + line * source.stride, std::min(lanes, lines - line), x + column,
                   y + line, xx, xy, yy);
    }
    use(i, sums.mean());
  }
}

}  // namespace

void gather_row(const PlanarPatch& patch, const PlacedKernels& row, int count, float* pixels) {
  const Planes source{patch.values.data(), patch.stride, patch.stride * patch.rect.height};
  const Blocks blocks(patch, row, count);
  with_channel_count(patch.channels, [&](auto channels) {
    const auto set = [=](int i, const Float4& mean) {
      std::memcpy(pixels + i * channels, &mean, channels * sizeof(float));
    };
    const auto clear = [=](int i) { std::fill_n(pixels + i * channels, channels, 0.0f); };
    gather_pixels<channels>(source, blocks, row.kernels, count, set, clear);
  });
}

void add_gathered_row(const PlanarPatch& patch, const PlacedKernels& row, const float* weights, int count,
                      float* pixels) {
  const Planes source{patch.values.data(), patch.stride, patch.stride * patch.rect.height};
  const Blocks blocks(patch, row, count);
  with_channel_count(patch.channels, [&](auto channels) {
    const auto add = [=](int i, const Float4& mean) {
      Float4 pixel{};
      std::memcpy(&pixel, pixels + i * channels, channels * sizeof(float));
      pixel += mean * weights[i];
      std::memcpy(pixels + i * channels, &pixel, channels * sizeof(float));
    };
    gather_pixels<channels>(source, blocks, row.kernels, count, add, [](int) {});
  });
}

}  // namespace cps
