#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/math/sobol.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

/// What a pane of glass lets through at a cosine.
Color through(const Material& m, float cosine) {
  BsdfParameters p{m.base_color.head<3>().array(), 0, m.roughness};
  p.transmission = m.transmission;
  return thin_glass_transmittance(p, cosine);
}

double worst(const Color& seen, const Color& exact) {
  return (seen / exact - 1).abs().maxCoeff();
}

}  // namespace

TEST_CASE("Clear glass lets 96 % pass straight on, less at a slant, tinted by its colour") {
  const Material tinted = glass({0.9f, 0.5f, 0.2f, 1});
  CHECK(worst(through(tinted, 1), Color(0.9f, 0.5f, 0.2f) * 0.96f) < 0.003);
  // Schlick's reflectance at cosine 0.1; the table that stands for it is exact to 0.003.
  CHECK(through(tinted, 0.1f).x() == Approx(0.9 * (1 - (0.04 + 0.96 * std::pow(0.9, 5)))).margin(0.003));
}

TEST_CASE("What lies behind panes is seen through them in their colours") {
  Scene scene;
  scene.materials = {glass({0.9f, 0.5f, 0.2f, 1}), lamp({1, 2, 3})};
  add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  add(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}));
  add(scene, quad({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}, 1));
  const RenderScene built(scene, no_light());
  const Color once = through(scene.materials[0], 1);
  // The panes mirror some of the lamp to one another: 4 % of 4 %.
  const Color seen = mean(render(built, camera({0, 0, 2}, {0, 0, 0}, 8, 8, 1), {.samples = 1024}));
  CHECK(worst(seen, once * once * Color(1, 2, 3)) < 0.01);
}

TEST_CASE("Sunlight through a pane is tinted by it, whether shadow rays find the sun or paths do") {
  Scene scene;
  scene.materials = {lambert({0.5f, 0.5f, 0.5f, 1}), glass({0.9f, 0.5f, 0.2f, 1})};
  add(scene, quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}));
  add(scene, quad({-50, 5, 50}, {100, 0, 0}, {0, 0, -100}, 1));
  const Vec3 to_sun = Vec3(0.4f, 0.7f, 0.2f).normalized();
  const Camera view = camera({0, 3, 4}, {0, 0, 0}, 8, 8, 0.5);
  for (double diameter : {0.01, 0.9}) {
    CAPTURE(diameter);
    const SkyAndSun light = sun_only(to_sun, Color::Constant(10), diameter);
    const RenderScene shaded(scene, light), open(scene_of(scene.materials[0], scene.meshes[0]), light);
    const RenderOptions options{.samples = 512, .max_shaded_vertices = 1};
    const Color ratio = mean(render(shaded, view, options)) / mean(render(open, view, options));
    CHECK(worst(ratio, through(scene.materials[1], to_sun.y())) < 0.015);
  }
}

TEST_CASE("Packets of shadow rays are tinted once, however they spread") {
  Scene scene;
  scene.materials = {glass({0.9f, 0.5f, 0.2f, 1})};
  add(scene, quad({-50, 5, 50}, {100, 0, 0}, {0, 0, -100}));
  const RenderScene built(scene, no_light());
  const Sun sun = make_sun(Vec3(0.1f, 0.9f, -0.1f).normalized(), 1, Color::Ones());
  for (std::uint32_t packet = 0; packet < 100; ++packet) {
    Ray rays[packet_size];
    bool active[packet_size];
    Color together[packet_size];
    for (std::uint32_t i = 0; i < packet_size; ++i) {
      rays[i].origin = {0.3f, 0, -0.7f};
      rays[i].direction = sun.sample(make_sobol_sample(1, 2, 3, packet * packet_size + i).pair(0));
      active[i] = i != packet % packet_size;
    }
    built.bvh.transmittance_coherent(rays, active, together);
    for (int i = 0; i < packet_size; ++i) {
      if (active[i]) REQUIRE(together[i].z() == Approx(built.bvh.transmittance(rays[i]).z()));
    }
  }
}

TEST_CASE("Glass spheres, coated and painted ones vanish in a white furnace") {
  Material coated = material({1, 1, 1, 1}, 0, 0.5f);
  coated.clearcoat = 1;
  coated.clearcoat_roughness = 0.2f;
  Material both = glass({1, 1, 1, 1});
  both.transmission = 0.5f;
  both.clearcoat = 0.5f;
  Material blended = material({1, 1, 1, 0.4f});
  blended.alpha_mode = AlphaMode::blend;
  blended.double_sided = true;
  for (const Material& m : {glass({1, 1, 1, 1}), coated, both, blended}) {
    const RenderScene scene(scene_of(m, sphere(1)), constant_light(3));
    const OIIO::ImageBuf image =
        render(scene, camera({0, 0, 5}, {0, 0, 0}, 16, 16, 15), {.samples = 256, .max_shaded_vertices = 40});
    CAPTURE(m.transmission, m.clearcoat);
    CHECK(mean(image).x() / 3 == Approx(1).margin(0.016));
  }
}

TEST_CASE("A masked hole in glass is a hole, half-covering glass tints half") {
  Scene scene;
  scene.materials = {glass({0.5f, 0.5f, 0.5f, 0.5f})};
  add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  Ray ray;
  ray.origin = {0.1f, 0.3f, 1};  // off the diagonal, where both triangles are met
  ray.direction = {0, 0, -1};
  const float pane = through(scene.materials[0], 1).x();
  const auto passing = [&](AlphaMode mode) {
    scene.materials[0].alpha_mode = mode;
    return RenderScene(scene, no_light()).bvh.transmittance(ray).x();
  };
  CHECK(passing(AlphaMode::opaque) == Approx(pane));
  CHECK(passing(AlphaMode::blend) == Approx(0.5 + 0.5 * pane));
  scene.materials[0].alpha_cutoff = 0.6f;
  CHECK(passing(AlphaMode::mask) == 1);
  scene.materials[0].alpha_cutoff = 0.4f;
  CHECK(passing(AlphaMode::mask) == Approx(pane));
}

TEST_CASE("Unlit surfaces show their colour as white paper on the ground would") {
  Scene scene;
  scene.materials = {material({0.2f, 0.4f, 0.8f, 1})};
  scene.materials[0].unlit = true;
  add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  const RenderScene built(scene, constant_light(5));
  const Color seen = mean(render(built, camera({0, 0, 2}, {0, 0, 0}, 4, 4, 10), {.samples = 16}));
  CHECK(worst(seen, 5 * Color(0.2f, 0.4f, 0.8f)) < 1e-3);
}
