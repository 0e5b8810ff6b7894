#include <OpenImageIO/imagebufalgo.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "numbers/srgb.h"
#include "sensor/photograph.h"

using namespace cps;

namespace {

/// Every sensor pixel has 200 electrons at white and 4 of read noise: enough noise to be seen in 8 bits, and
/// little enough that gray levels of .2 to .5 do not clip.
constexpr double full_well_e = 200, read_noise_e = 4;

SensorOptions noisy_sensor(int binning) {
  return {.exposure_bias_min_ev = 0,
          .exposure_bias_max_ev = 0,
          .full_well_min_e = full_well_e,
          .full_well_max_e = full_well_e,
          .read_noise_min_e = read_noise_e,
          .read_noise_max_e = read_noise_e,
          .binning = binning};
}

/// Shares of white that the 8-bit pixels of a photographed gray card stand for.
std::vector<double> gray_card(double level, int side, int binning, std::uint64_t seed) {
  OIIO::ImageBuf light(OIIO::ImageSpec(side, side, 1, OIIO::TypeDesc::FLOAT));
  OIIO::ImageBufAlgo::fill(light, {static_cast<float>(level)});
  const OIIO::ImageBuf image =
      photograph_light(light, 1, sensor_of(noisy_sensor(binning), Stream{seed}), PixelFormat::gray);
  const auto* code = static_cast<const std::uint8_t*>(image.localpixels());
  std::vector<double> values;
  for (std::size_t i = 0; i < image.spec().image_pixels(); ++i)
    values.push_back(linear_from_srgb(code[i] / 255.0));
  return values;
}

/// Means of n x n pixels of a square image.
std::vector<double> block_means(const std::vector<double>& image, int side, int n) {
  std::vector<double> means(image.size() / (n * n), 0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      means[static_cast<std::size_t>(y / n) * (side / n) + x / n] +=
          image[static_cast<std::size_t>(y) * side + x] / (n * n);
  return means;
}

struct CardMoments {
  double mean, variance;
};

CardMoments moments_of(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (double value : values) squares += (value - mean) * (value - mean);
  return {mean, squares / static_cast<double>(values.size())};
}

/// What rounding to 8 bits adds to the variance at a gray level (Sheppard 1898): a twelfth of the step's
/// square.
double rounding_variance(double level) {
  const double code = 255 * srgb_from_linear(level);
  const double step = linear_from_srgb((code + 0.5) / 255) - linear_from_srgb((code - 0.5) / 255);
  return step * step / 12;
}

}  // namespace

TEST_CASE("binned noise has the variance of all its sensor pixels' photons and reads") {
  constexpr int side = 400;
  for (const double level : {0.2, 0.5})
    for (const int n : {1, 2, 4}) {
      INFO("level " << level << ", binning " << n);
      const CardMoments card = moments_of(gray_card(level, side, n, 10 + n));
      // Of the sum over n² sensor pixels, as a share of its white.
      const double white_e = n * n * full_well_e, reads_e2 = n * n * read_noise_e * read_noise_e;
      const double expected = (level * white_e + reads_e2) / (white_e * white_e) + rounding_variance(level);
      // Five standard errors, of a mean and of a normal's variance; one hundredth for clipped tails and the
      // curve's bend within a step.
      constexpr double pixels = side * side;
      CHECK(std::abs(card.mean - level) < 5 * std::sqrt(expected / pixels) + 2e-4);
      CHECK(card.variance == Approx(expected).epsilon(5 * std::sqrt(2 / pixels) + 0.01));
    }
}

TEST_CASE("an image with binning is as noisy as the reduced image of a sensor without") {
  constexpr int reduced_side = 200;
  constexpr double level = 0.3, reduced_pixels = reduced_side * reduced_side;
  for (const int n : {2, 3, 4}) {
    INFO("binning " << n);
    const int side = n * reduced_side;
    const CardMoments binned_card = moments_of(gray_card(level, reduced_side, n, 20 + n));
    const CardMoments reduced = moments_of(block_means(gray_card(level, side, 1, 30 + n), side, n));
    // The reduced image's pixels are rounded before the mean is taken, the others after.
    const double rounding = rounding_variance(level);
    const double ratio = (binned_card.variance - rounding) / (reduced.variance - rounding / (n * n));
    CHECK(binned_card.mean ==
          Approx(reduced.mean).margin(5 * std::sqrt(2 * reduced.variance / reduced_pixels) + 2e-4));
    // Five standard errors of the ratio of two normals' variances.
    CHECK(ratio == Approx(1).epsilon(5 * std::sqrt(4 / reduced_pixels) + 0.01));
  }
}

TEST_CASE("binning changes nothing of a drawn sensor but electrons by its square and reads by itself") {
  for (int i = 0; i < 20; ++i) {
    const Stream stream = substream(make_stream(3, "binning"), i);
    SensorOptions options;
    const Sensor one = sensor_of(options, stream);
    for (const int n : {1, 2, 5, 16}) {
      options.binning = n;
      const Sensor sensor = sensor_of(options, stream);
      CHECK(sensor.settings.exposure_bias_ev == one.settings.exposure_bias_ev);
      CHECK(sensor.settings.full_well_e == one.settings.full_well_e * (n * n));
      CHECK(sensor.settings.read_noise_e == one.settings.read_noise_e * n);
      CHECK(sensor.noise.key == one.noise.key);
    }
  }
}

TEST_CASE("binning outside 1 to 16 is refused by the recipe key's name") {
  for (const int n : {-1, 0, 17}) {
    const SensorOptions options{.binning = n};
    CHECK(options.fault() == "sensor_binning: must lie in [1, 16]");
  }
  for (const int n : {1, 16}) CHECK(SensorOptions{.binning = n}.fault() == "");
}
