#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "dataset/verify/registration.h"
#include "random/counter_hash.h"

using namespace cps;

namespace {

/// A picture of plane waves, seen with each pixel moved by `displacement`, plus noise.
OIIO::ImageBuf waves(const std::function<std::pair<double, double>(double, double)>& displacement,
                     double noise, std::uint64_t seed) {
  OIIO::ImageBuf image(OIIO::ImageSpec(320, 200, 1, OIIO::TypeDesc::FLOAT));
  auto* pixels = static_cast<float*>(image.localpixels());
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) {
      const auto [dx, dy] = displacement(x, y);
      const double u = x - dx, v = y - dy;
      double value = 0.5;
      for (int k = 1; k <= 6; ++k)
        value += 0.06 * std::sin(0.11 * k * u + 0.07 * (7 - k) * v + k * k) +
                 0.03 * std::cos(0.3 * v - 0.05 * k * u);
      pixels[y * 320 + x] =
          static_cast<float>(value + noise * random_normal(make_stream(seed, "noise"), y * 320 + x));
    }
  return image;
}

}  // namespace

TEST_CASE("a subpixel shift is found to 0.02 px") {
  const auto still = [](double, double) { return std::pair(0.0, 0.0); };
  for (const auto& [dx, dy] : {std::pair(0.0, 0.0), std::pair(0.3, -0.2), std::pair(-0.05, 0.4)}) {
    const auto moved = [dx = dx, dy = dy](double, double) { return std::pair(dx, dy); };
    const Registration found = register_pictures(waves(still, 0.02, 1), waves(moved, 0.02, 2));
    CHECK(found.shift_x_px == Approx(dx).margin(0.02));
    CHECK(found.shift_y_px == Approx(dy).margin(0.02));
    CHECK(found.blocks > 10);
  }
}

TEST_CASE("the reported noise matches the scatter of the shifts") {
  const auto still = [](double, double) { return std::pair(0.0, 0.0); };
  double square = 0, reported = 0;
  constexpr int trials = 24;
  for (int i = 0; i < trials; ++i) {
    const Registration found = register_pictures(waves(still, 0.1, 2 * i), waves(still, 0.1, 2 * i + 1));
    square += found.shift_x_px * found.shift_x_px + found.shift_y_px * found.shift_y_px;
    reported += found.shift_noise_px * found.shift_noise_px;
    CHECK(found.block_rms_px < 0.1);
  }
  // 48 squares: their mean lies within a factor of 2 with more than 99.9 %; the model is no better than that.
  CHECK(square / reported > 0.4);
  CHECK(square / reported < 2.5);
}

TEST_CASE("a stretch about the middle shows in the blocks, not in the shift") {
  const auto still = [](double, double) { return std::pair(0.0, 0.0); };
  const auto stretched = [](double x, double y) {
    return std::pair(0.004 * (x - 159.5), 0.004 * (y - 99.5));
  };
  const Registration found = register_pictures(waves(still, 0.02, 1), waves(stretched, 0.02, 2));
  CHECK(std::hypot(found.shift_x_px, found.shift_y_px) < 0.08);
  CHECK(found.block_rms_px > 0.2);
  CHECK(found.block_rms_px < 0.6);  // 0.004 · rms distance of 108 px
  CHECK(found.psnr_db > 20);
}

TEST_CASE("noisy pictures of one view correlate, pictures of two views do not") {
  const auto still = [](double, double) { return std::pair(0.0, 0.0); };
  const auto elsewhere = [](double x, double y) { return std::pair(1000 - 2 * y, 500 + 1.7 * x); };
  const OIIO::ImageBuf here = waves(still, 0.05, 1);
  CHECK(register_pictures(here, waves(still, 0.05, 2)).correlation > .9);
  CHECK(std::abs(register_pictures(here, waves(elsewhere, 0.05, 2)).correlation) < .2);
}

TEST_CASE("pictures of different sizes are refused") {
  CHECK_THROWS(register_pictures(OIIO::ImageBuf(OIIO::ImageSpec(10, 10, 1, OIIO::TypeDesc::FLOAT)),
                                 OIIO::ImageBuf(OIIO::ImageSpec(10, 11, 1, OIIO::TypeDesc::FLOAT))));
}
