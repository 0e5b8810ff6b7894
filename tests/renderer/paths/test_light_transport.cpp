#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "renderer/materials/bsdf.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// A level square of 40 m around the origin.
Mesh ground(int material = 0) {
  return quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, material);
}

/// Looks down at it.
Camera above() {
  return camera({0, 3, 4}, {0, 0, 0}, 12, 12, 0.5);
}

/// Radiance of a level surface towards `to_eye` under sky and sun, by quadrature over directions: nothing is
/// sampled.
Color reflected_by_level_surface(const Color& base_color, float metallic, float roughness, const Vec3& to_eye,
                                 const SkyAndSun& light) {
  const auto local = [](const Vec3& v) { return Vec3(v.x(), -v.z(), v.y()); };
  const Bsdf bsdf = make_bsdf({base_color, metallic, roughness}, local(to_eye));
  constexpr int rows = 800, columns = 1600;
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (int r = 0; r < rows; ++r) {
    const float y = (static_cast<float>(r) + 0.5f) / rows;
    for (int c = 0; c < columns; ++c) {
      const Vec3 d = direction_at((static_cast<float>(c) + 0.5f) / columns, y);
      sum += (evaluate_bsdf(bsdf, local(to_eye), local(d)).f_cos * light.sky.radiance(d)).cast<double>();
    }
  }
  const Color sky = (sum * (2.0 * std::numbers::pi / (rows * columns))).cast<float>();
  return sky + evaluate_bsdf(bsdf, local(to_eye), local(light.sun.direction)).f_cos * light.sun.radiance /
                   light.sun.pdf;
}

}  // namespace

TEST_CASE("A plane lit by the sun has radiance albedo/π · E · cos") {
  // The dielectric keeps a layer that reflects 4 %: Lambert to a tenth, and the BSDF itself exactly.
  const Vec3 to_sun = Vec3(0.4f, 0.8f, 0.3f).normalized();
  const SkyAndSun light = sun_only(to_sun, Color(90, 80, 70));
  const Color albedo(0.5f, 0.3f, 0.2f);
  const RenderScene scene(scene_of(material({0.5f, 0.3f, 0.2f, 1}), ground()), light);
  const Color seen = mean(render(scene, above(), {.samples = 256}));
  const Color lambert = albedo / pi * Color(90, 80, 70) * to_sun.y();
  CHECK((seen / lambert - 1).abs().maxCoeff() < 0.12f);
  const Color exact = reflected_by_level_surface(albedo, 0, 1, Vec3(0, 0.6f, 0.8f), light);
  CHECK((seen / exact - 1).abs().maxCoeff() < 0.01f);
}

TEST_CASE("A white sphere vanishes in a white furnace; a dark one is its albedo") {
  for (float albedo : {1.0f, 0.25f}) {
    const RenderScene scene(scene_of(material({albedo, albedo, albedo, 1}), sphere(1)), constant_light(3));
    const OIIO::ImageBuf image = render(scene, camera({0, 0, 5}, {0, 0, 0}, 16, 16, 15), {.samples = 256});
    const float seen = mean(image).x() / 3;
    if (albedo == 1.0f) {
      CHECK(seen == Approx(1).margin(0.01));
    } else {
      CHECK(seen > 0.25f);  // and a little gloss
      CHECK(seen < 0.25f + 0.06f);
    }
  }
}

TEST_CASE("Sky and sun with next-event estimation and MIS agree with quadrature, from matt to glossy") {
  const SkyAndSun day = make_clear_day({.sun_elevation_deg = 35, .sun_azimuth_deg = 20});
  const Color base(0.8f, 0.5f, 0.3f);
  for (const auto& [metallic, roughness] :
       {std::pair{0.0f, 1.0f}, {0.0f, 0.4f}, {1.0f, 0.7f}, {1.0f, 0.35f}, {0.6f, 0.5f}}) {
    CAPTURE(metallic, roughness);
    const RenderScene scene(scene_of(material({0.8f, 0.5f, 0.3f, 1}, metallic, roughness), ground()), day);
    const Color seen = mean(render(scene, above(), {.samples = 1024}));
    const Color exact = reflected_by_level_surface(base, metallic, roughness, Vec3(0, 0.6f, 0.8f), day);
    CHECK((seen / exact - 1).abs().maxCoeff() < 0.015f);
  }
}

TEST_CASE("A mirror shows the sun at its own brightness") {
  // Only BSDF samples find the disc in a mirror; MIS must give them its full weight.
  const Vec3 to_sun(0, 0.6f, -0.8f);
  const SkyAndSun light = sun_only(to_sun, Color::Constant(50), 0.3);
  const RenderScene scene(scene_of(material({1, 1, 1, 1}, 1, 0), ground()), light);
  const OIIO::ImageBuf image = render(scene, camera({0, 3, 4}, {0, 0, 0}, 9, 9, 4), {.samples = 256});
  CHECK(pixel(image, 4, 4).x() / light.sun.radiance.x() == Approx(1).epsilon(0.02));
}

TEST_CASE("Light between surfaces adds up as a geometric series") {
  // Inside a closed sphere that emits e and reflects a, n shaded vertices see e (1 + a + … + a^n): each of
  // them gathers the lamps' light, as it does the sun's.
  Material m = material({0.5f, 0.5f, 0.5f, 1});
  m.emissive = {2, 2, 2};
  m.double_sided = true;
  const RenderScene scene(scene_of(m, sphere(2, 0, 48)), constant_light(0));
  const Camera view = camera({0.1, 0.2, 0}, {0, 0, 1}, 8, 8, 90);
  // The surface's albedo, layer and all, averaged over what it sends back: from two vertices to three.
  double seen[4];
  for (int n = 1; n <= 3; ++n)
    seen[n] = mean(render(scene, view, {.samples = 1024, .max_shaded_vertices = n})).x();
  const double albedo = seen[1] / 2 - 1;
  CHECK(albedo > 0.5);
  CHECK(albedo < 0.56);
  CHECK(seen[2] == Approx(2 * (1 + albedo + albedo * albedo)).epsilon(0.01));
  CHECK(seen[3] == Approx(2 * (1 + albedo + albedo * albedo + albedo * albedo * albedo)).epsilon(0.01));
}

TEST_CASE("Half the sky gives half the light: an infinite wall stands on the ground") {
  // At the foot of a black wall a level matt surface sees half of a constant sky.
  Scene scene;
  scene.materials = {material({0.5f, 0.5f, 0.5f, 1}), material({0, 0, 0, 1}, 1, 1)};
  add(scene, ground(0));
  add(scene, quad({-2000, -1, 0}, {4000, 0, 0}, {0, 2000, 0}, 1));
  const RenderScene walled(scene, constant_light(1)),
      open(scene_of(scene.materials[0], ground()), constant_light(1));
  const Camera view = camera({0, 2, 0.5}, {0, 0, 0.05}, 6, 6, 1);
  const double ratio =
      mean(render(walled, view, {.samples = 1024})).x() / mean(render(open, view, {.samples = 1024})).x();
  CHECK(ratio == Approx(0.5).margin(0.02));
}

TEST_CASE("A closed box is dark inside") {
  const auto light_inside = [](const Vec3& place) {
    Scene scene;
    scene.materials = {material({0.9f, 0.9f, 0.9f, 1})};
    scene.materials[0].double_sided = true;
    const Eigen::Affine3f turned =
        Eigen::Translation3f(place) * Eigen::AngleAxisf(0.4f, Vec3(1, 1, 0).normalized());
    const Vec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    for (const Mesh& wall : {quad({-1, -1, -1}, x, y), quad({-1, -1, 1}, x, y), quad({-1, -1, -1}, z, y),
                             quad({1, -1, -1}, z, y), quad({-1, -1, -1}, x, z), quad({-1, 1, -1}, x, z)}) {
      add(scene, wall, turned);
    }
    const RenderScene built(scene, sun_only({0.3f, 0.9f, 0.2f}, Color::Constant(100)));
    const Eigen::Vector3d at = place.cast<double>();
    return mean(render(built, camera(at, at + Eigen::Vector3d(1, 0.3, 0), 24, 24, 120), {.samples = 64}))
        .maxCoeff();
  };
  CHECK(light_inside({0, 0, 0}) == 0);
  // Far from the origin coordinates are rounded to 30 µm, and so are the walls' edges: one path in 10,000 may
  // slip out. An open surface would send back about 30.
  CHECK(light_inside({300, 20, -400}) < 30 * 1e-4f);
}

TEST_CASE("Options out of range are refused by name") {
  CHECK_THAT(RenderOptions{.samples = 0}.fault(), Catch::StartsWith("samples:"));
  CHECK_THAT(RenderOptions{.samples = 65537}.fault(), Catch::StartsWith("samples:"));
  CHECK_THAT(RenderOptions{.max_shaded_vertices = 0}.fault(), Catch::StartsWith("max_shaded_vertices:"));
  CHECK(RenderOptions{}.fault().empty());
}
