#include <catch2/catch.hpp>

#include "random/counter_hash.h"
#include "renderer/materials/alpha_mask.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

Texture alpha_noise(int width, int height, Wrap wrap, bool nearest) {
  Texture t;
  t.name = "alpha";
  t.width = width;
  t.height = height;
  t.wrap_u = t.wrap_v = wrap;
  t.nearest = nearest;
  for (int i = 0; i < width * height; ++i) {
    const auto a = static_cast<std::uint8_t>(random_below(make_stream(1, "alpha"), i, 256));
    t.rgba.insert(t.rgba.end(), {255, 255, 255, a});
  }
  return t;
}

/// A 2 × 2 quad before the origin's −z, seen from +z, whose left half is transparent to `alpha`.
Scene half_transparent(AlphaMode mode, std::uint8_t alpha) {
  Scene scene;
  Texture t;
  t.name = "half";
  t.width = 2;
  t.height = 1;
  t.nearest = true;
  t.rgba = {255, 255, 255, alpha, 255, 255, 255, 255};
  scene.textures.push_back(t);
  Material m = material({1, 1, 1, 1});
  m.base_color_texture.texture = 0;
  m.alpha_mode = mode;
  scene.materials.push_back(m);
  add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  return scene;
}

Ray forward(float x, std::uint32_t id = 0) {
  Ray ray;
  ray.origin = {x, 0.1f, 1};
  ray.direction = {0, 0, -1};
  ray.id = id;
  return ray;
}

}  // namespace

TEST_CASE("The alpha table decides as the filtered texture does") {
  for (Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
    for (bool nearest : {false, true}) {
      const MipTexture texture = make_mip_texture(alpha_noise(11, 6, wrap, nearest), true);
      const AlphaMask mask = make_alpha_mask(texture, 0.5f);
      for (int i = 0; i < 20000; ++i) {
        const Stream s = make_stream(2, "uv");
        const Eigen::Vector2f uv(static_cast<float>(random_uniform(s, 2 * i, -2, 3)),
                                 static_cast<float>(random_uniform(s, 2 * i + 1, -2, 3)));
        const float alpha = texture.sample(uv, 0).w();
        if (std::abs(alpha - 0.5f) < 1e-5f) continue;  // rounding decides
        REQUIRE(mask.passes(uv) == (alpha >= 0.5f));
      }
    }
  }
}

TEST_CASE("Masked holes let rays through, single and in packets, to the eye and to the light") {
  const RenderScene scene(half_transparent(AlphaMode::mask, 100), constant_light(1));
  CHECK_FALSE(scene.bvh.intersect(forward(-0.5f)));
  CHECK(scene.bvh.intersect(forward(0.5f)));
  CHECK(scene.bvh.transmittance(forward(-0.5f)).x() == 1);
  CHECK(scene.bvh.transmittance(forward(0.5f)).x() == 0);
  Ray rays[packet_size];
  bool active[packet_size];
  for (int i = 0; i < packet_size; ++i) rays[i] = forward(i % 2 ? 0.5f : -0.5f), active[i] = i != 7;
  Hit hits[packet_size];
  scene.bvh.intersect_coherent(rays, active, hits);
  Color transmittance[packet_size];
  scene.bvh.transmittance_coherent(rays, active, transmittance);
  for (int i = 0; i < 7; ++i) {
    CHECK(static_cast<bool>(hits[i]) == (i % 2 == 1));
    CHECK(transmittance[i].x() == (i % 2 ? 0 : 1));
  }
}

TEST_CASE("Opaque materials ignore alpha") {
  const RenderScene scene(half_transparent(AlphaMode::opaque, 0), constant_light(1));
  CHECK(scene.bvh.intersect(forward(-0.5f)));
  CHECK(scene.bvh.transmittance(forward(-0.5f)).x() == 0);
}

TEST_CASE("The cutoff is met, not passed") {
  Scene scene = half_transparent(AlphaMode::mask, 102);
  scene.materials[0].alpha_cutoff = 102 / 255.0f;
  CHECK(RenderScene(scene, constant_light(1)).bvh.intersect(forward(-0.5f)));
  scene.materials[0].alpha_cutoff = 103 / 255.0f;
  CHECK_FALSE(RenderScene(scene, constant_light(1)).bvh.intersect(forward(-0.5f)));
  scene.materials[0].base_color.w() = 0.5f;  // the factor takes part
  scene.materials[0].alpha_cutoff = 102 / 255.0f;
  CHECK_FALSE(RenderScene(scene, constant_light(1)).bvh.intersect(forward(-0.5f)));
}

TEST_CASE("Half-transparent surfaces stop their share of rays and of light") {
  const RenderScene scene(half_transparent(AlphaMode::blend, 64), constant_light(1));
  const double alpha = 64 / 255.0;
  CHECK(scene.bvh.transmittance(forward(-0.5f)).x() == Approx(1 - alpha));
  CHECK(scene.bvh.transmittance(forward(0.5f)).x() == 0);
  constexpr int rays = 20000;
  int stopped = 0;
  for (std::uint32_t id = 0; id < rays; ++id)
    stopped += static_cast<bool>(scene.bvh.intersect(forward(-0.5f, id)));
  CHECK(std::abs(stopped - alpha * rays) < 4 * std::sqrt(alpha * (1 - alpha) * rays));
}

TEST_CASE("Light behind several half-transparent surfaces is the product, in packets too") {
  Scene scene = half_transparent(AlphaMode::blend, 128);
  add(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}));
  add(scene, quad({-1, -1, -2}, {2, 0, 0}, {0, 2, 0}));
  const RenderScene render_scene(scene, constant_light(1));
  const double expected = std::pow(1 - 128 / 255.0, 3);
  CHECK(render_scene.bvh.transmittance(forward(-0.5f)).x() == Approx(expected));
  Ray rays[packet_size];
  bool active[packet_size];
  for (int i = 0; i < packet_size; ++i)
    rays[i] = forward(-0.9f + 0.1f * static_cast<float>(i)), active[i] = true;
  Color transmittance[packet_size];
  render_scene.bvh.transmittance_coherent(rays, active, transmittance);
  for (const Color& t : transmittance) CHECK(t.x() == Approx(expected));
}

TEST_CASE("A half-transparent sheet decides anew at each bounce, alike on both triangles of a quad") {
  Scene scene;
  Material sheet = lambert({0, 0, 0, 0.5f});
  sheet.alpha_mode = AlphaMode::blend;
  sheet.double_sided = true;
  scene.materials = {lambert({0.5f, 0.5f, 0.5f, 1}), sheet};
  add(scene, quad({-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}));
  add(scene, quad({-500, 1, 500}, {1000, 0, 0}, {0, 0, -1000}, 1));
  const RenderScene built(scene, constant_light(1));
  constexpr int side = 16;
  const OIIO::ImageBuf image =
      render(built, camera({0, 3, 0.001f}, {0, 0, 0}, side, side, 40), {.samples = 1024});
  // The quad's diagonal crosses the picture's middle.
  double sums[2] = {0, 0};
  int pixels[2] = {0, 0};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x + y == side - 1) continue;
      const int half = x + y < side - 1 ? 0 : 1;
      sums[half] += image.getchannel(x, y, 0, 0);
      ++pixels[half];
    }
  // Half of the samples see the sheet, which is black; the others ground in half of the sky's light.
  for (int half : {0, 1}) CHECK(sums[half] / pixels[half] == Approx(0.125).epsilon(0.01));
}
