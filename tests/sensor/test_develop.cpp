#include <OpenImageIO/imagebufalgo.h>
#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "sensor/develop.h"

using namespace cps;

namespace {

OIIO::ImageBuf constant_image(int width, int height, float value) {
  OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT));
  OIIO::ImageBufAlgo::fill(image, {value, value, value});
  return image;
}

const std::uint8_t* bytes(const OIIO::ImageBuf& image) {
  return static_cast<const std::uint8_t*>(image.localpixels());
}

double decode_srgb(double code) {
  const double v = code / 255;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST_CASE("without noise to speak of, codes are rounded sRGB") {
  const SensorSettings quiet{.exposure_bias_ev = 0, .full_well_e = 1e12, .read_noise_e = 0};
  for (int code = 0; code <= 255; ++code) {
    const OIIO::ImageBuf image = constant_image(2, 2, static_cast<float>(decode_srgb(code)));
    CHECK(bytes(develop(image, 1.0, quiet, make_stream(0, "n")))[0] == code);
  }
  CHECK(bytes(develop(constant_image(2, 2, 7.0f), 1.0, quiet, make_stream(0, "n")))[0] == 255);
  const SensorSettings bright{.exposure_bias_ev = 1, .full_well_e = 1e12, .read_noise_e = 0};
  CHECK(bytes(develop(constant_image(2, 2, 0.1f), 2.0, bright, make_stream(0, "n")))[0] ==
        bytes(develop(constant_image(2, 2, 0.4f), 1.0, quiet, make_stream(0, "n")))[0]);
}

TEST_CASE("contrast is a power about middle gray, and 1 is none") {
  const auto code = [](double linear, double contrast) {
    const SensorSettings quiet{.full_well_e = 1e12, .read_noise_e = 0, .contrast = contrast};
    return int(
        bytes(develop(constant_image(1, 1, static_cast<float>(linear)), 1, quiet, make_stream(0, "n")))[0]);
  };
  for (double contrast : {.6, 1., 1.7})
    for (double linear : {.02, .09, .18, .4, .9}) {
      const double toned = .18 * std::pow(linear / .18, contrast);
      // The code whose light is nearest; on its border, either.
      CHECK(std::abs(code(linear, contrast) - code(toned, 1)) <= (contrast == 1 ? 0 : 1));
    }
  CHECK(code(.09, 1.7) < code(.09, 1));
  CHECK(code(.5, 1.7) > code(.5, 1));
  CHECK(code(.18, 3) == code(.18, 1));
}

TEST_CASE("noise has the variance of shot plus read noise") {
  const int side = 400;
  const double signal = 0.2, full_well = 1000, read = 5;
  const SensorSettings settings{.exposure_bias_ev = 0, .full_well_e = full_well, .read_noise_e = read};
  const OIIO::ImageBuf image = constant_image(side, side, static_cast<float>(signal));
  const OIIO::ImageBuf developed = develop(image, 1.0, settings, make_stream(1, "noise"));
  double sum = 0, squares = 0;
  const double n = 3.0 * side * side;
  for (int i = 0; i < 3 * side * side; ++i) {
    const double v = decode_srgb(bytes(developed)[i]);
    sum += v, squares += v * v;
  }
  const double mean = sum / n, variance = squares / n - mean * mean;
  const double expected = (signal * full_well + read * read) / (full_well * full_well);
  // Five standard errors: of a mean, and of a normal's variance (with rounding's extra variance below 2 %).
  CHECK(std::abs(mean - signal) < 5 * std::sqrt(expected / n) + 1e-3);
  CHECK(variance == Approx(expected).epsilon(5 * std::sqrt(2 / n) + 0.02));
}

TEST_CASE("metering brings the centre to the key and ignores the rim and the sun") {
  OIIO::ImageBuf image = constant_image(64, 32, 100.0f);
  OIIO::ImageBufAlgo::fill(image, {3.0f, 3.0f, 3.0f}, OIIO::ROI(16, 48, 8, 24));
  CHECK(meter_exposure(image) == Approx(0.06));
  const float sun[3] = {1e6f, 1e6f, 1e6f};
  image.setpixel(20, 10, 0, sun);
  CHECK(meter_exposure(image) == Approx(0.06).epsilon(0.02));
  CHECK(meter_exposure(image) ==
        Approx(0.18 * 512 / (511 * 3.0 + 8 * 3.0)));  // it counts eight times the median
  CHECK(meter_exposure(constant_image(8, 8, 0)) == 1.0);
}

TEST_CASE("images that share an exposure are metered together without the pixels that a mask leaves out") {
  // Middle halves of 512 and 128 pixels.
  const OIIO::ImageBuf large = constant_image(64, 32, 3), small = constant_image(32, 16, 1);
  const MeteredImage both[] = {{&large}, {&small}};
  CHECK(meter_exposure(both) == Approx(0.18 * 640 / (512 * 3.0 + 128 * 1.0)));
  CHECK(meter_exposure(std::span(both, 1)) == meter_exposure(large));

  OIIO::ImageBuf half_black = constant_image(64, 32, 0),
                 mask(OIIO::ImageSpec(64, 32, 1, OIIO::TypeDesc::UINT8));
  OIIO::ImageBufAlgo::fill(half_black, {3.0f, 3.0f, 3.0f}, OIIO::ROI(0, 32, 0, 32));
  OIIO::ImageBufAlgo::fill(mask, {1.0f}, OIIO::ROI(0, 32, 0, 32));
  const MeteredImage masked{&half_black, &mask}, whole{&half_black};
  CHECK(meter_exposure(std::span(&masked, 1)) == Approx(0.06));
  CHECK(meter_exposure(std::span(&whole, 1)) == Approx(0.12));
  OIIO::ImageBufAlgo::zero(mask);
  CHECK(meter_exposure(std::span(&masked, 1)) == 1.0);
}

TEST_CASE("developing gives the same bytes for any number of threads") {
  const OIIO::ImageBuf image = constant_image(123, 57, 0.3f);
  const auto run = [&](int threads) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return develop(image, 1.0, {}, make_stream(2, "noise"));
  };
  const OIIO::ImageBuf one = run(1), four = run(4);
  CHECK(std::memcmp(one.localpixels(), four.localpixels(), 123 * 57 * 3) == 0);
}

TEST_CASE("drawn settings stay in range and impossible ranges are refused") {
  const SensorOptions options;
  for (int i = 0; i < 1000; ++i) {
    const SensorSettings s = draw_sensor(options, substream(make_stream(0, "sensor"), i));
    CHECK(s.full_well_e >= options.full_well_min_e);
    CHECK(s.full_well_e <= options.full_well_max_e);
    CHECK(std::abs(s.exposure_bias_ev) <= 0.5);
  }
  CHECK(options.fault() == "");
  SensorOptions broken;
  broken.full_well_min_e = 0;
  CHECK_THAT(broken.fault(), Catch::StartsWith("full_well_min_e"));
}
