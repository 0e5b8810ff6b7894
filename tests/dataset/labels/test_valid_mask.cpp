#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "dataset/labels/valid_mask.h"

using namespace cps;

namespace {

/// An equidistant fisheye: a ray lands `focal` times its angle from the axis off the principal point, which
/// is not in the middle.
ModelCamera equidistant_camera(int width, int height, double focal) {
  return {"", {width, height, focal, focal, 0.5 * width - 3, 0.5 * height + 2.25}, KannalaBrandt{}};
}

/// Distance from the principal point of the farthest point of a pixel's kernel.
double farthest_px(const Pinhole& pinhole, int x, int y) {
  return std::hypot(std::abs(x - pinhole.cx) + 1.5, std::abs(y - pinhole.cy) + 1.5);
}

}  // namespace

TEST_CASE("a pixel is valid if its whole kernel lies in the fisheye's circle") {
  const ModelCamera camera = equidistant_camera(80, 64, 10);
  const std::optional<OIIO::ImageBuf> mask = valid_mask(camera);
  REQUIRE(mask);
  REQUIRE(mask->spec().width == 80);
  REQUIRE(mask->spec().height == 64);
  REQUIRE(mask->nchannels() == 1);
  const double rim = 10 * std::numbers::pi;  // a ray straight backwards
  const auto* value = static_cast<const std::uint8_t*>(mask->localpixels());
  int valid = 0, invalid = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 80; ++x, ++value) {
      const double farthest = farthest_px(camera.pinhole, x, y);
      if (std::abs(farthest - rim) < 1e-6) continue;
      const bool is_inside = farthest < rim;
      CHECK(int(*value) == (is_inside ? 255 : 0));
      ++(is_inside ? valid : invalid);
    }
  CHECK(valid > 2000);
  CHECK(invalid > 1500);
}

TEST_CASE("a unified lens' mask is the circle in which its rays land") {
  // The radius sin t / (cos t + xi) ends at 1 / sqrt(xi² - 1) for xi = 1.2, and nowhere for 0.9.
  const double rim = 20 / std::sqrt(1.2 * 1.2 - 1);
  const ModelCamera camera{"", {96, 96, 20, 20, 47.5, 47.5}, UnifiedSpherical{1.2, {}}};
  const std::optional<OIIO::ImageBuf> mask = valid_mask(camera);
  REQUIRE(mask);
  int differing = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      differing += (mask->getchannel(x, y, 0, 0) > 0) != (farthest_px(camera.pinhole, x, y) < rim);
  CHECK(differing == 0);
  CHECK_FALSE(valid_mask({"", {96, 96, 20, 20, 47.5, 47.5}, UnifiedSpherical{0.9, {}}}));
}

TEST_CASE(
    "there is no mask where the lens shows the frame and its pixels' kernels and one where these leave it") {
  // The kernels' farthest corner lies a pixel beyond the frame's on each axis.
  const ModelCamera plain = equidistant_camera(64, 48, 1);
  const double dx = std::max(plain.pinhole.cx + 0.5, 63.5 - plain.pinhole.cx),
               dy = std::max(plain.pinhole.cy + 0.5, 47.5 - plain.pinhole.cy);
  const double corner = std::hypot(dx, dy), kernel = std::hypot(dx + 1, dy + 1);
  const auto with_rim = [&](double rim_px) {
    ModelCamera camera = plain;
    camera.pinhole.fx = camera.pinhole.fy = rim_px / std::numbers::pi;
    return valid_mask(camera);
  };
  CHECK_FALSE(with_rim(kernel + 0.01));
  const auto mask = with_rim(0.5 * (corner + kernel));
  REQUIRE(mask);
  int invalid = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) invalid += mask->getchannel(x, y, 0, 0) == 0;
  CHECK(invalid >= 1);
  CHECK(invalid < 10);
}

TEST_CASE("pixels that are not valid become black in any type and the others stay") {
  OIIO::ImageBuf mask(OIIO::ImageSpec(3, 2, 1, OIIO::TypeDesc::UINT8));
  const std::uint8_t valid[] = {255, 0, 255, 0, 0, 255};
  mask.set_pixels(mask.roi(), OIIO::TypeDesc::UINT8, valid);
  for (const OIIO::TypeDesc type : {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::FLOAT}) {
    OIIO::ImageBuf image(OIIO::ImageSpec(3, 2, 3, type));
    const std::vector<float> light(18, 0.5f);
    image.set_pixels(image.roi(), OIIO::TypeDesc::FLOAT, light.data());
    black_out(image, mask);
    for (int i = 0; i < 6; ++i)
      for (int c = 0; c < 3; ++c) CHECK((image.getchannel(i % 3, i / 3, 0, c) > 0) == (valid[i] == 255));
  }
}
