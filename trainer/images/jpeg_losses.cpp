// A transform of our own rather than a round trip through libjpeg-turbo: entropy coding would take most of
// the time, and the pixels, and with them a trained model's weights, would depend on the installed library. A
// test compares the result with libjpeg's.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trainer/images/corruptions.h"

namespace cps {
namespace {

constexpr int side = 8;
using Block = std::array<float, side * side>;

/// ITU-T T.81 (1992), table K.1.
constexpr std::array<int, side * side> luminance_table{
    16, 11,  10,  16, 24, 40, 51, 61, 12,  12,  14,  19,  26, 58, 60, 55,  14,  13,  16,  24, 40, 57,
    69, 56,  14,  17, 22, 29, 51, 87, 80,  62,  18,  22,  37, 56, 68, 109, 103, 77,  24,  35, 55, 64,
    81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98,  112, 100, 103, 99};

/// Quantisation steps at a quality of 1…100 (libjpeg's jpeg_quality_scaling).
Block quantisation_steps(int quality) {
  const int scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  Block steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    steps[i] = static_cast<float>(std::clamp((luminance_table[i] * scale + 50) / 100, 1, 255));
  return steps;
}

/// Row u: the orthonormal cosine basis function of frequency u.
Block cosines() {
  Block c;
  for (int u = 0; u < side; ++u)
    for (int x = 0; x < side; ++x)
      c[u * side + x] = static_cast<float>(std::sqrt((u == 0 ? 1.0 : 2.0) / side) *
                                           std::cos((2 * x + 1) * u * std::numbers::pi / (2 * side)));
  return c;
}

/// The matrix product a·b, each factor transposed first if asked.
Block product(const Block& a, bool transpose_a, const Block& b, bool transpose_b) {
  Block result;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      float sum = 0;
      for (int k = 0; k < side; ++k)
        sum += (transpose_a ? a[k * side + i] : a[i * side + k]) *
               (transpose_b ? b[j * side + k] : b[k * side + j]);
      result[i * side + j] = sum;
    }
  return result;
}

}  // namespace

void compress_as_jpeg(GrayImage& image, int quality) {
  static const Block basis = cosines();
  const Block steps = quantisation_steps(quality);
  const auto [width, height] = image.size;
  const auto index = [&](int x, int y) {  // blocks beyond the border repeat its pixels
    return static_cast<std::size_t>(std::min(y, height - 1)) * width + std::min(x, width - 1);
  };
  for (int y0 = 0; y0 < height; y0 += side)
    for (int x0 = 0; x0 < width; x0 += side) {
      Block block;
      for (int i = 0; i < side * side; ++i)
        block[i] = static_cast<float>(image.pixels[index(x0 + i % side, y0 + i / side)]) - 128;
      Block spectrum = product(product(basis, false, block, false), false, basis, true);
      for (int i = 0; i < side * side; ++i) spectrum[i] = std::round(spectrum[i] / steps[i]) * steps[i];
      block = product(product(basis, true, spectrum, false), false, basis, false);
      for (int i = 0; i < side * side; ++i)
        if (x0 + i % side < width && y0 + i / side < height)
          image.pixels[index(x0 + i % side, y0 + i / side)] =
              static_cast<std::uint8_t>(std::clamp(std::lround(block[i] + 128), 0l, 255l));
    }
}

}  // namespace cps
