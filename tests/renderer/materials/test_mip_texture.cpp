#include <catch2/catch.hpp>
#include <cmath>

#include "random/counter_hash.h"
#include "renderer/materials/mip_texture.h"
#include "renderer/materials/srgb.h"

using namespace cps;

namespace {

Texture noise(int width, int height, bool srgb) {
  Texture t;
  t.name = "noise";
  t.width = width;
  t.height = height;
  t.srgb = srgb;
  for (int i = 0; i < 4 * width * height; ++i) {
    t.rgba.push_back(static_cast<std::uint8_t>(random_below(make_stream(2, "texels"), i, 256)));
  }
  return t;
}

Eigen::Array4d linear_mean(const Texture& t) {
  Eigen::Array4d sum = Eigen::Array4d::Zero();
  for (int i = 0; i < t.width * t.height; ++i) {
    for (int c = 0; c < 4; ++c) {
      const double v = t.rgba[4 * i + c] / 255.0;
      sum[c] += t.srgb && c < 3 ? (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4)) : v;
    }
  }
  return sum / (t.width * t.height);
}

/// Texel (x, y) of an unmipped texture in linear light, by definition.
Eigen::Array4f texel_of(const Texture& t, int x, int y) {
  Eigen::Array4f v;
  for (int c = 0; c < 4; ++c) {
    const int code = t.rgba[4 * (y * t.width + x) + c];
    v[c] = t.srgb && c < 3 ? srgb_decode_table()[code] : static_cast<float>(code) / 255;
  }
  return v;
}

}  // namespace

TEST_CASE("The top of the pyramid is the mean in linear light, odd sizes included") {
  for (bool srgb : {false, true}) {
    for (const auto& [width, height] : {std::pair{64, 64}, {37, 21}, {1, 19}, {128, 2}}) {
      CAPTURE(srgb, width, height);
      const Texture source = noise(width, height, srgb);
      const MipTexture texture = make_mip_texture(source, false);
      CHECK(texture.levels.back().width == 1);
      CHECK(texture.levels.back().height == 1);
      const Eigen::Array4f top = texture.sample({0.3f, 0.8f}, 20);
      // One rounding to 8 bits: half a code, whose width in linear light is at most 2.4/255 for sRGB.
      const double tolerance = srgb ? 0.5 * 2.4 / 255 : 0.5 / 255;
      CHECK((top.cast<double>() - linear_mean(source)).abs().maxCoeff() < tolerance + 1e-5);
    }
  }
}

TEST_CASE("sRGB codes survive a round trip") {
  for (int code = 0; code < 256; ++code) CHECK(srgb_encode(srgb_decode_table()[code]) == code);
}

TEST_CASE("Lookups at the full image interpolate between texel centres") {
  const Texture source = noise(13, 7, true);
  const MipTexture texture = make_mip_texture(source, false);
  for (int i = 0; i < 500; ++i) {
    const Stream s = make_stream(4, "uv");
    const double u = random_uniform(s, 2 * i, 0.5 / 13, 1 - 0.5 / 13),
                 v = random_uniform(s, 2 * i + 1, 0.5 / 7, 1 - 0.5 / 7);
    const double px = u * 13 - 0.5, py = v * 7 - 0.5;
    const int x = std::min(static_cast<int>(px), 11), y = std::min(static_cast<int>(py), 5);
    const auto fx = static_cast<float>(px - x), fy = static_cast<float>(py - y);
    const Eigen::Array4f expected =
        (texel_of(source, x, y) * (1 - fx) + texel_of(source, x + 1, y) * fx) * (1 - fy) +
        (texel_of(source, x, y + 1) * (1 - fx) + texel_of(source, x + 1, y + 1) * fx) * fy;
    const Eigen::Array4f seen = texture.sample({static_cast<float>(u), static_cast<float>(v)}, -3);
    REQUIRE((seen - expected).abs().maxCoeff() < 1e-4f);
  }
}

TEST_CASE("Coordinates outside [0, 1] wrap as the sampler says") {
  Texture source = noise(8, 8, false);
  const auto value = [&](Wrap wrap, float u) {
    source.wrap_u = source.wrap_v = wrap;
    return make_mip_texture(source, false).sample({u, 0.4f}, 0);
  };
  const auto same = [](const Eigen::Array4f& a, const Eigen::Array4f& b) {
    return (a - b).abs().maxCoeff() < 1e-4f;
  };
  for (float u : {0.1f, 0.3f, 0.55f, 0.97f}) {
    CHECK(same(value(Wrap::repeat, u + 3), value(Wrap::repeat, u)));
    CHECK(same(value(Wrap::repeat, u - 2), value(Wrap::repeat, u)));
    CHECK(same(value(Wrap::mirrored_repeat, 2 - u), value(Wrap::mirrored_repeat, u)));
    CHECK(same(value(Wrap::mirrored_repeat, -u), value(Wrap::mirrored_repeat, u)));
    CHECK(same(value(Wrap::clamp_to_edge, 1 + u), value(Wrap::clamp_to_edge, 1)));
    CHECK(same(value(Wrap::clamp_to_edge, -u), value(Wrap::clamp_to_edge, 0)));
  }
  // Across repeat's seam the last texel meets the first.
  source.wrap_u = source.wrap_v = Wrap::repeat;
  const Eigen::Array4f seam = make_mip_texture(source, false).sample({0, 0.5f / 8}, 0);
  CHECK(same(seam, 0.5f * (texel_of(source, 7, 0) + texel_of(source, 0, 0))));
}

TEST_CASE("Nearest textures give unmixed texels at every level of detail") {
  Texture source = noise(8, 8, true);
  source.nearest = true;
  const MipTexture texture = make_mip_texture(source, false);
  for (float lod : {-1.0f, 0.0f, 5.0f})
    CHECK((texture.sample({0.40f, 0.90f}, lod) == texel_of(source, 3, 7)).all());
}

TEST_CASE("Transparent texels lend no colour where alpha weighs") {
  Texture source = noise(4, 4, true);
  for (int i = 0; i < 16; ++i) {
    const bool leaf = i % 2 == 0;
    source.rgba[4 * i] = leaf ? 40 : 255;
    source.rgba[4 * i + 3] = leaf ? 255 : 0;
  }
  const Eigen::Array4f top = make_mip_texture(source, true).sample({0.5f, 0.5f}, 9);
  CHECK(top.x() == Approx(srgb_decode_table()[40]).margin(1e-4));
  CHECK(top.w() == Approx(0.5).margin(0.003));
}
