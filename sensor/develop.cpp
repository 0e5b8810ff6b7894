#include "sensor/develop.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "numbers/luminance.h"
#include "numbers/metering.h"
#include "numbers/srgb.h"

namespace cps {
namespace {

/// The linear values at which the rounded 8-bit sRGB code steps up: code(v) is the number of thresholds ≤ v.
/// Searching the table is exact and cheaper than a power per value.
std::array<float, 255> srgb_thresholds() {
  std::array<float, 255> thresholds;
  for (int code = 1; code <= 255; ++code) {
    const double encoded = (code - 0.5) / 255.0;
    thresholds[code - 1] = static_cast<float>(linear_from_srgb(encoded));
  }
  return thresholds;
}

/// The thresholds for values before a tone curve of this contrast.
std::array<float, 255> before_contrast(std::array<float, 255> thresholds, double contrast) {
  constexpr double middle_gray = .18;
  for (float& threshold : thresholds)
    threshold = static_cast<float>(middle_gray * std::pow(threshold / middle_gray, 1 / contrast));
  return thresholds;
}

std::uint8_t srgb_code(const std::array<float, 255>& thresholds, float linear) {
  const auto above = std::upper_bound(thresholds.begin(), thresholds.end(), linear);
  return static_cast<std::uint8_t>(above - thresholds.begin());
}

/// Adds the luminances of the middle half, in width and height.
void add_middle(const MeteredImage& image, std::vector<float>& luminances) {
  const int width = image.linear->spec().width, height = image.linear->spec().height;
  const auto* pixels = static_cast<const float*>(image.linear->localpixels());
  const auto* valid = image.valid ? static_cast<const std::uint8_t*>(image.valid->localpixels()) : nullptr;
  luminances.reserve(luminances.size() + static_cast<std::size_t>(width / 2 + 1) * (height / 2 + 1));
  for (int y = height / 4; y < height - height / 4; ++y)
    for (int x = width / 4; x < width - width / 4; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * width + x;
      if (valid && valid[at] == 0) continue;
      const float* rgb = pixels + 3 * at;
      luminances.push_back(luminance(rgb[0], rgb[1], rgb[2]));
    }
}

}  // namespace

double meter_exposure(const OIIO::ImageBuf& linear_master) {
  const MeteredImage image{&linear_master};
  return meter_exposure(std::span(&image, 1));
}

double meter_exposure(std::span<const MeteredImage> images) {
  std::vector<float> luminances;
  for (const MeteredImage& image : images) add_middle(image, luminances);
  return luminances.empty() ? 1 : metered_exposure(luminances).value_or(1);
}

OIIO::ImageBuf luminance(const OIIO::ImageBuf& linear) {
  const int width = linear.spec().width, height = linear.spec().height;
  OIIO::ImageBuf gray(OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::FLOAT));
  const auto* from = static_cast<const float*>(linear.localpixels());
  auto* to = static_cast<float*>(gray.localpixels());
  for (std::size_t i = 0; i < static_cast<std::size_t>(width) * height; ++i)
    to[i] = luminance(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
  return gray;
}

double exposure_factor(double exposure, const SensorSettings& settings) {
  return exposure * std::exp2(settings.exposure_bias_ev);
}

OIIO::ImageBuf expose(const OIIO::ImageBuf& linear, double exposure, const SensorSettings& settings) {
  OIIO::ImageBuf exposed(linear.spec());
  const auto factor = static_cast<float>(exposure_factor(exposure, settings));
  const auto* from = static_cast<const float*>(linear.localpixels());
  auto* to = static_cast<float*>(exposed.localpixels());
  for (std::size_t i = 0; i < linear.spec().image_pixels() * linear.spec().nchannels; ++i)
    to[i] = factor * from[i];
  return exposed;
}

OIIO::ImageBuf develop(const OIIO::ImageBuf& linear, double exposure, const SensorSettings& settings,
                       Stream noise) {
  static const std::array<float, 255> plain = srgb_thresholds();
  const std::array<float, 255> thresholds =
      settings.contrast == 1 ? plain : before_contrast(plain, settings.contrast);
  const int width = linear.spec().width, height = linear.spec().height, channels = linear.spec().nchannels;
  OIIO::ImageBuf encoded(OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::UINT8));
  const auto* from = static_cast<const float*>(linear.localpixels());
  auto* to = static_cast<std::uint8_t*>(encoded.localpixels());
  const double scale = exposure_factor(exposure, settings) * settings.full_well_e;
  const double read_variance = settings.read_noise_e * settings.read_noise_e;
  tbb::parallel_for(0, height, [&](int y) {
    const std::size_t row = static_cast<std::size_t>(y) * width * channels;
    for (std::size_t i = row; i < row + static_cast<std::size_t>(width) * channels; ++i) {
      const double electrons = std::max(0.0, scale * from[i]);
      const double noisy = electrons + std::sqrt(electrons + read_variance) * random_normal(noise, i);
      to[i] = srgb_code(thresholds, static_cast<float>(noisy / settings.full_well_e));
    }
  });
  return encoded;
}

}  // namespace cps
