#include "trainer/images/corruptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace cps {
namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l));
}

template <typename Curve>
void apply_curve(GrayImage& image, Curve curve) {
  std::array<std::uint8_t, 256> table;
  for (int v = 0; v < 256; ++v) table[v] = to_byte(curve(v));
  for (std::uint8_t& pixel : image.pixels) pixel = table[pixel];
}

/// The pixel, or the border's nearest.
float at(const std::vector<float>& pixels, const ImageSize& size, int x, int y) {
  return pixels[static_cast<std::size_t>(std::clamp(y, 0, size.height - 1)) * size.width +
                std::clamp(x, 0, size.width - 1)];
}

float bilinear(const std::vector<float>& pixels, const ImageSize& size, double x, double y) {
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
  return std::lerp(std::lerp(at(pixels, size, x0, y0), at(pixels, size, x0 + 1, y0), u),
                   std::lerp(at(pixels, size, x0, y0 + 1), at(pixels, size, x0 + 1, y0 + 1), u), v);
}

/// The pixels as the mean, weighted by `weights`, of themselves moved by `offsets` (x, y).
void average(GrayImage& image, const std::vector<std::array<double, 2>>& offsets,
             const std::vector<double>& weights) {
  const std::vector<float> before(image.pixels.begin(), image.pixels.end());
  const double total = std::reduce(weights.begin(), weights.end());
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      double sum = 0;
      for (std::size_t i = 0; i < offsets.size(); ++i)
        sum += weights[i] * bilinear(before, image.size, x + offsets[i][0], y + offsets[i][1]);
      image.pixels[static_cast<std::size_t>(y) * image.size.width + x] = to_byte(sum / total);
    }
}

}  // namespace

void blur(GrayImage& image, double sigma_px) {
  if (!(sigma_px > 0)) return;
  const int reach = static_cast<int>(std::ceil(3 * sigma_px));
  std::vector<float> weights;
  for (int i = -reach; i <= reach; ++i)
    weights.push_back(static_cast<float>(std::exp(-.5 * i * i / (sigma_px * sigma_px))));
  const float total = std::reduce(weights.begin(), weights.end());
  for (float& w : weights) w /= total;
  const std::vector<float> before(image.pixels.begin(), image.pixels.end());
  std::vector<float> rows(before.size());
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      float sum = 0;
      for (int i = -reach; i <= reach; ++i) sum += weights[i + reach] * at(before, image.size, x + i, y);
      rows[static_cast<std::size_t>(y) * image.size.width + x] = sum;
    }
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      float sum = 0;
      for (int i = -reach; i <= reach; ++i) sum += weights[i + reach] * at(rows, image.size, x, y + i);
      image.pixels[static_cast<std::size_t>(y) * image.size.width + x] = to_byte(sum);
    }
}

void motion_blur(GrayImage& image, double length_px, double angle_rad) {
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * length_px)));
  std::vector<std::array<double, 2>> offsets;
  for (int i = 0; i < steps; ++i) {
    const double along = length_px * ((i + .5) / steps - .5);
    offsets.push_back({along * std::cos(angle_rad), along * std::sin(angle_rad)});
  }
  average(image, offsets, std::vector<double>(offsets.size(), 1));
}

void apply_gamma(GrayImage& image, double gamma) {
  apply_curve(image, [&](int v) { return 255 * std::pow(v / 255.0, gamma); });
}

void apply_contrast(GrayImage& image, double contrast, double brightness) {
  apply_curve(image, [&](int v) { return 127.5 + contrast * (v - 127.5) + brightness; });
}

void add_iso_noise(GrayImage& image, double sigma, Stream stream) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double v = image.pixels[i];
    image.pixels[i] = to_byte(v + sigma * std::sqrt(.2 + .8 * v / 255) * random_normal(stream, i));
  }
}

void cut_out(GrayImage& image, double max_share, Stream stream) {
  const auto [width, height] = image.size;
  const int w = static_cast<int>(std::lround(random_uniform(stream, 0, 0, max_share) * width)),
            h = static_cast<int>(std::lround(random_uniform(stream, 1, 0, max_share) * height)),
            x0 = static_cast<int>(random_below(stream, 2, width - w + 1)),
            y0 = static_cast<int>(random_below(stream, 3, height - h + 1));
  const std::uint8_t gray = to_byte(std::reduce(image.pixels.begin(), image.pixels.end(), 0.0) /
                                    static_cast<double>(image.pixels.size()));
  for (int y = y0; y < y0 + h; ++y)
    std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * width + x0, w, gray);
}

}  // namespace cps
