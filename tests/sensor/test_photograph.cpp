#include <OpenImageIO/imagebufalgo.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/warp/master_camera.h"
#include "numbers/angles.h"
#include "sensor/photograph.h"

using namespace cps;

namespace {

const CroppedLens barrel{{.k1 = -0.05, .k2 = 0.01, .k3 = 0, .p1 = 1e-3, .p2 = 0},
                         pinhole_from_hfov(120, 80, radians(60.0)),
                         frame_on_plane(pinhole_from_hfov(120, 80, radians(66.0)))};

/// A wall of one colour that was rendered without noise.
Master flat_master(float red, float green, float blue, double exposure) {
  const Pinhole camera = master_camera(pinhole_from_hfov(120, 80, radians(66.0)), {}, 0.2);
  OIIO::ImageBuf half(OIIO::ImageSpec(camera.width, camera.height, 3, OIIO::TypeDesc::FLOAT));
  OIIO::ImageBufAlgo::fill(half, {red, green, blue});
  Master master = master_from_halves(half, half, camera);
  master.exposure = exposure;
  return master;
}

Sensor quiet(double exposure_bias_ev = 0) {
  return {{.exposure_bias_ev = exposure_bias_ev, .full_well_e = 1e12, .read_noise_e = 0}, Stream{1}};
}

double srgb(double linear) {
  return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

const std::uint8_t* codes(const OIIO::ImageBuf& image) {
  return static_cast<const std::uint8_t*>(image.localpixels());
}

/// Mean and standard deviation of a picture's gray values: luma of three channels, or the only one.
std::pair<double, double> gray_moments(const OIIO::ImageBuf& image) {
  const std::size_t pixels = image.spec().image_pixels();
  const int channels = image.spec().nchannels;
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* p = codes(image) + i * channels;
    const double value = channels == 1 ? p[0] : 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    sum += value, squares += value * value;
  }
  const double mean = sum / static_cast<double>(pixels);
  return {mean, std::sqrt(squares / static_cast<double>(pixels) - mean * mean)};
}

}  // namespace

TEST_CASE("a photographed wall has the exposed colour in every format") {
  const Master wall = flat_master(0.4f, 0.1f, 0.05f, 0.5);  // with a bias of 1 EV: exposure 1
  const OIIO::ImageBuf rgb = photograph(wall, barrel, quiet(1), PixelFormat::rgb);
  REQUIRE(rgb.spec().nchannels == 3);
  REQUIRE(rgb.spec().width == 120);
  REQUIRE(rgb.spec().height == 80);
  for (std::size_t i = 0; i < rgb.spec().image_pixels(); ++i) {
    REQUIRE(codes(rgb)[3 * i] == std::lround(srgb(0.4)));
    REQUIRE(codes(rgb)[3 * i + 1] == std::lround(srgb(0.1)));
    REQUIRE(codes(rgb)[3 * i + 2] == std::lround(srgb(0.05)));
  }
  const OIIO::ImageBuf gray = photograph(wall, barrel, quiet(1), PixelFormat::gray);
  REQUIRE(gray.spec().nchannels == 1);
  CHECK(codes(gray)[0] == std::lround(srgb(0.2126 * 0.4 + 0.7152 * 0.1 + 0.0722 * 0.05)));
  const OIIO::ImageBuf linear = photograph(wall, barrel, quiet(3), PixelFormat::linear);
  REQUIRE(linear.spec().format == OIIO::TypeDesc::FLOAT);
  CHECK(linear.getchannel(60, 40, 0, 0) == Approx(4 * 0.4).epsilon(1e-5));
}

TEST_CASE("light on the sensor becomes the pixels that a master's does after the lens") {
  const Master wall = flat_master(0.4f, 0.1f, 0.05f, 0.5);
  const Sensor sensor{{.exposure_bias_ev = 0.5, .full_well_e = 500, .read_noise_e = 3}, Stream{5}};
  OIIO::ImageBuf light(OIIO::ImageSpec(120, 80, 3, OIIO::TypeDesc::FLOAT));
  OIIO::ImageBufAlgo::fill(light, {0.4f, 0.1f, 0.05f});
  for (const PixelFormat format : {PixelFormat::rgb, PixelFormat::gray}) {
    const OIIO::ImageBuf direct = photograph_light(light, 0.5, sensor, format),
                         warped = photograph(wall, barrel, sensor, format);
    REQUIRE(direct.spec().nchannels == warped.spec().nchannels);
    int differing = 0;
    for (std::size_t i = 0; i < direct.spec().image_bytes(); ++i)
      differing += std::abs(codes(direct)[i] - codes(warped)[i]) > 1;  // the warp rounds
    CHECK(differing == 0);
  }
  const OIIO::ImageBuf linear = photograph_light(light, 0.5, sensor, PixelFormat::linear);
  REQUIRE(linear.spec().format == OIIO::TypeDesc::FLOAT);
  CHECK(linear.getchannel(7, 9, 0, 1) == Approx(0.1 * 0.5 * std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("a master of luminance gives the gray image that the coloured one gives") {
  Master wall = flat_master(0.3f, 0.2f, 0.1f, 1);
  const Sensor sensor{{.exposure_bias_ev = 0, .full_well_e = 500, .read_noise_e = 3}, Stream{5}};
  const OIIO::ImageBuf coloured = photograph(wall, barrel, sensor, PixelFormat::gray);
  wall.light = {luminance(wall.light.picture), luminance(wall.light.noise)};
  const OIIO::ImageBuf gray = photograph(wall, barrel, sensor, PixelFormat::gray);
  CHECK(std::equal(codes(gray), codes(gray) + 120 * 80, codes(coloured)));
}

TEST_CASE("luma of three channels is less noisy than a sensor without colours, by the norm of its weights") {
  const Master wall = flat_master(0.2f, 0.2f, 0.2f, 1);
  const Sensor sensor{{.exposure_bias_ev = 0, .full_well_e = 300, .read_noise_e = 2}, Stream{7}};
  const auto [rgb_mean, rgb_deviation] = gray_moments(photograph(wall, barrel, sensor, PixelFormat::rgb));
  const auto [gray_mean, gray_deviation] = gray_moments(photograph(wall, barrel, sensor, PixelFormat::gray));
  CHECK(rgb_mean == Approx(gray_mean).margin(0.5));
  const double norm = std::sqrt(0.2126 * 0.2126 + 0.7152 * 0.7152 + 0.0722 * 0.0722);
  // Relative standard error of a deviation over n pixels: 1/√2n, so of the ratio 1/√n; five of them.
  CHECK(rgb_deviation / gray_deviation == Approx(norm).epsilon(5 / std::sqrt(120.0 * 80)));
}

TEST_CASE("after_lens is called once, and settings and noise follow from the stream alone") {
  const Master wall = flat_master(0.2f, 0.3f, 0.4f, 1);
  int calls = 0;
  const auto shoot = [&](std::uint64_t seed) {
    return photograph(wall, barrel, sensor_of({}, Stream{seed}), PixelFormat::rgb, [&] { ++calls; });
  };
  const OIIO::ImageBuf first = shoot(1), again = shoot(1), other = shoot(2);
  CHECK(calls == 3);
  CHECK(std::equal(codes(first), codes(first) + 3 * 120 * 80, codes(again)));
  CHECK_FALSE(std::equal(codes(first), codes(first) + 3 * 120 * 80, codes(other)));
}
