#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "renderer/materials/bsdf.h"
#include "renderer/paths/path_steps.h"
#include "tests/renderer/estimates.h"

using namespace cps;
using namespace cps::handmade;

namespace {

using std::numbers::pi;

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
Eigen::Array3d reflected_by_level_surface(const BsdfParameters& surface, const Vec3& to_eye,
                                          const SkyAndSun& light) {
  const auto local = [](const Vec3& v) { return Vec3(v.x(), -v.z(), v.y()); };
  const Bsdf bsdf = make_bsdf(surface, local(to_eye));
  constexpr int rows = 800, columns = 1600;
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (int r = 0; r < rows; ++r) {
    const float y = (static_cast<float>(r) + 0.5f) / rows;
    for (int c = 0; c < columns; ++c) {
      const Vec3 d = direction_at((static_cast<float>(c) + 0.5f) / columns, y);
      sum += (evaluate_bsdf(bsdf, local(to_eye), local(d)).f_cos * light.sky.radiance(d)).cast<double>();
    }
  }
  const Color from_sun = evaluate_bsdf(bsdf, local(to_eye), local(light.sun.direction)).f_cos *
                         light.sun.radiance / light.sun.pdf;
  return sum * (2.0 * pi / (rows * columns)) + from_sun.cast<double>();
}

/// Radiance that a grey surface reflects to a viewer at this cosine, by quadrature, where the radiance that
/// arrives is a function of the cosine of incidence alone.
template <class Light>
double reflected(const BsdfParameters& surface, float cosine, Light light) {
  const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
  const Bsdf bsdf = make_bsdf(surface, wo);
  constexpr int rows = 200, columns = 100;
  double sum = 0;
  for (int r = 0; r < rows; ++r) {
    const float z = (static_cast<float>(r) + 0.5f) / rows, sine = std::sqrt(1 - z * z);
    for (int c = 0; c < columns; ++c) {
      const double azimuth = 2 * pi * (c + 0.5) / columns;
      const Vec3 wi(sine * static_cast<float>(std::cos(azimuth)),
                    sine * static_cast<float>(std::sin(azimuth)), z);
      sum += evaluate_bsdf(bsdf, wo, wi).f_cos.x() * light(z);
    }
  }
  return sum * 2 * pi / (rows * columns);
}

/// Mean over a picture's pixels of a function of the ray through their centre.
template <class F>
double mean_over_pixels(const Camera& camera, F f) {
  double sum = 0;
  for (int y = 0; y < camera.pinhole.height; ++y)
    for (int x = 0; x < camera.pinhole.width; ++x) {
      const Eigen::Vector2d at = to_plane(camera.pinhole, {x, y});
      sum += f(Eigen::Vector3d(camera.world_from_camera.linear() *
                               Eigen::Vector3d(at.x(), at.y(), 1).normalized()));
    }
  return sum / (camera.pinhole.width * camera.pinhole.height);
}

Eigen::Array3d grey(double value) {
  return Eigen::Array3d::Constant(value);
}

}  // namespace

TEST_CASE("A matt plane lit by the sun has radiance albedo/π · E · cos, a layered one that of quadrature") {
  const Vec3 to_sun = Vec3(0.4f, 0.8f, 0.3f).normalized();
  const SkyAndSun light = sun_only(to_sun, Color(90, 80, 70));
  const Color albedo(0.5f, 0.3f, 0.2f);
  const RenderScene matt(scene_of(lambert({0.5f, 0.3f, 0.2f, 1}), ground()), light);
  const Eigen::Array3d closed_form = (albedo / float(pi) * Color(90, 80, 70) * to_sun.y()).cast<double>();
  CHECK(standard_errors_off(mean_over_seeds(matt, above(), {.samples = 16}), closed_form, 1e-4) <
        max_standard_errors);
  const RenderScene layered(scene_of(material({0.5f, 0.3f, 0.2f, 1}), ground()), light);
  const Eigen::Array3d exact = reflected_by_level_surface({albedo, 0, 1}, Vec3(0, 0.6f, 0.8f), light);
  CHECK(standard_errors_off(mean_over_seeds(layered, above(), {.samples = 16}), exact, 3e-4) <
        max_standard_errors);
}

TEST_CASE("A sphere in a white furnace shows its directional albedo: all of the light if it is white") {
  const Camera view = camera({0, 0, 5}, {0, 0, 0}, 16, 16, 15);
  for (float albedo : {1.0f, 0.25f}) {
    CAPTURE(albedo);
    const RenderScene scene(scene_of(material({albedo, albedo, albedo, 1}), sphere(1)), constant_light(3));
    const double exact = mean_over_pixels(view, [&](const Eigen::Vector3d& direction) {
      const Eigen::Vector3d from(0, 0, 5);
      const double along = -direction.dot(from), miss2 = from.squaredNorm() - along * along;
      const auto cosine = static_cast<float>(std::sqrt(1 - miss2));  // at the surface of the unit sphere
      return reflected({Color::Constant(albedo), 0, 1}, cosine, [](float) { return 3.0; });
    });
    CHECK(standard_errors_off(mean_over_seeds(scene, view, {.samples = 16}), grey(exact), 1e-3) <
          max_standard_errors);
    if (albedo == 1.0f) CHECK(exact == Approx(3).epsilon(0.01));
  }
}

TEST_CASE("Sky and sun with next-event estimation and MIS agree with quadrature, from matt to glossy") {
  const SkyAndSun day = make_clear_day({.sun_elevation_deg = 35, .sun_azimuth_deg = 20});
  const Color base(0.8f, 0.5f, 0.3f);
  for (const auto& [metallic, roughness] :
       {std::pair{0.0f, 1.0f}, {0.0f, 0.4f}, {1.0f, 0.7f}, {1.0f, 0.35f}, {0.6f, 0.5f}}) {
    CAPTURE(metallic, roughness);
    const RenderScene scene(scene_of(material({0.8f, 0.5f, 0.3f, 1}, metallic, roughness), ground()), day);
    const Eigen::Array3d exact =
        reflected_by_level_surface({base, metallic, roughness}, Vec3(0, 0.6f, 0.8f), day);
    CHECK(standard_errors_off(mean_over_seeds(scene, above(), {.samples = 64}), exact, 1e-3) <
          max_standard_errors);
  }
}

TEST_CASE("Where the light of the base is known the sky is sampled as often as the layers above it") {
  // What layers reflect of the sky is found by light samples and by draws of their own; both must add up to
  // what a surface with a black base reflects, however few of a vertex's paths draw either.
  constexpr int samples = 4096, seeds = 32;
  constexpr float times = 3;
  const SkyAndSun overcast = make_sky_and_sun({.sky = SkyModel::overcast});
  const Vec3 to_eye(0, 0.6f, 0.8f);
  struct Layers {
    float roughness, clearcoat;
  };
  for (const Layers& layers : {Layers{0.5f, 0}, Layers{1, 0}, Layers{0.8f, 1}}) {
    CAPTURE(layers.roughness, layers.clearcoat);
    Material m = material({0.6f, 0.6f, 0.6f, 1}, 0, layers.roughness);
    m.clearcoat = layers.clearcoat;
    m.clearcoat_roughness = 0.5f;
    const RenderScene scene(scene_of(m, ground()), overcast);
    const Ray ray{.origin = Vec3(0.3f, 0, 0.1f) + 5 * to_eye, .direction = -to_eye};
    const Hit hit = scene.bvh.intersect(ray);
    REQUIRE(hit);
    Surface surface = make_surface(scene.placed, ray, hit, 0, 0);
    const float share = times * (1 - surface.bsdf.diffuse_probability);
    REQUIRE(share < 0.7f);
    leave_out_base(surface.bsdf, times);

    int sky_rays = 0;
    const Estimate seen = estimate(seeds, [&](int seed) {
      Eigen::Array3d sum = Eigen::Array3d::Zero();
      for (int i = 0; i < samples; ++i) {
        Path path;
        path.ray = ray;
        path.random =
            make_sobol_sample(static_cast<std::uint64_t>(seed), 0, 0, static_cast<std::uint32_t>(i));
        path.alive = true;
        const ShadowRay sky = light_and_scatter(scene, path, surface).sky;
        if (path.alive) leave_scene(scene, path);
        sum += path.radiance.cast<double>();
        if (!sky.wanted) continue;
        sum += sky.contribution.cast<double>();
        ++sky_rays;
      }
      return Eigen::Array3d(sum / samples);
    });
    const Eigen::Array3d exact = reflected_by_level_surface({.base_color = Color::Zero(),
                                                             .roughness = layers.roughness,
                                                             .clearcoat = layers.clearcoat,
                                                             .clearcoat_roughness = 0.5f},
                                                            to_eye, overcast);
    CHECK(standard_errors_off(seen, exact, 2e-3) < max_standard_errors);
    CHECK(sky_rays == Approx(share * samples * seeds).epsilon(0.03));
  }
}

TEST_CASE("A mirror shows the sun at its own brightness") {
  // Only BSDF samples find the disc in a mirror; MIS must give them its full weight.
  const Vec3 to_sun(0, 0.6f, -0.8f);
  const SkyAndSun light = sun_only(to_sun, Color::Constant(50), 0.3);
  const RenderScene scene(scene_of(material({1, 1, 1, 1}, 1, 0), ground()), light);
  // The mirror is a GGX surface of α = 0.001, whose long tails send 0.02 % beside the disc.
  const Estimate seen = mean_over_seeds(scene, camera({0, 3, 4}, {0, 0, 0}, 3, 3, 0.1), {.samples = 64});
  CHECK(standard_errors_off(seen, grey(light.sun.radiance.x()), 1e-3) < max_standard_errors);
}

TEST_CASE("Light between surfaces adds up as the series of reflections") {
  // A closed sphere emits e within and reflects. A chord meets the sphere under the same angle at both ends,
  // so the radiance L(µ) that a viewer sees at cosine µ after n reflections is L_n = e + ∫ f L_{n−1} cos.
  // Each of a path's n shaded vertices gathers the lamps' light, as it does the sun's.
  constexpr float radius = 2;
  constexpr double emitted = 2;
  Material m = material({0.5f, 0.5f, 0.5f, 1});
  m.emissive = Vec3::Constant(emitted);
  m.double_sided = true;
  const RenderScene scene(scene_of(m, sphere(radius, 0, 48)), constant_light(0));
  const Camera view = camera({0.1, 0.2, 0}, {0, 0, 1}, 8, 8, 90);
  constexpr int cells = 64;
  std::vector<double> radiance(cells, emitted);  // by cosine, at the cells' middles
  const auto at_cosine = [&](float cosine) {
    const float at = std::clamp(cosine * cells - 0.5f, 0.0f, cells - 1.001f);
    const auto cell = static_cast<std::size_t>(at);
    return radiance[cell] + (at - static_cast<float>(cell)) * (radiance[cell + 1] - radiance[cell]);
  };
  for (int n = 1; n <= 3; ++n) {
    CAPTURE(n);
    std::vector<double> next;
    for (int cell = 0; cell < cells; ++cell)
      next.push_back(emitted + reflected({Color::Constant(0.5f), 0, 1},
                                         (static_cast<float>(cell) + 0.5f) / cells, at_cosine));
    radiance = next;
    const double exact = mean_over_pixels(view, [&](const Eigen::Vector3d& direction) {
      const double along = view.world_from_camera.translation().dot(direction);
      const double offset2 = view.world_from_camera.translation().squaredNorm() - along * along;
      return at_cosine(static_cast<float>(std::sqrt(1 - offset2 / (radius * radius))));
    });
    const Estimate seen = mean_over_seeds(scene, view, {.samples = 16, .max_shaded_vertices = n});
    CHECK(standard_errors_off(seen, grey(exact), 2e-3) < max_standard_errors);
  }
}

TEST_CASE("Half the sky gives half the light: an infinite wall stands on the ground") {
  // At the foot of a black wall a level matt surface sees half of a constant sky.
  Scene scene;
  scene.materials = {lambert({0.5f, 0.5f, 0.5f, 1}), lambert({0, 0, 0, 1})};
  add(scene, ground(0));
  const RenderScene open(scene, constant_light(1));
  add(scene, quad({-2000, -1, 0}, {4000, 0, 0}, {0, 2000, 0}, 1));
  const RenderScene walled(scene, constant_light(1));
  const Camera view = camera({0, 2, 0.5}, {0, 0, 0.05}, 6, 6, 1);
  CHECK(mean(render(open, view, {.samples = 16})).x() == Approx(0.5).epsilon(1e-5));
  CHECK(standard_errors_off(mean_over_seeds(walled, view, {.samples = 64}), grey(0.25), 2e-4) <
        max_standard_errors);
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
  // slip out. Walls of an open box would show about 30.
  CHECK(light_inside({300, 20, -400}) < 30 * 1e-4f);
}

TEST_CASE("Options out of range are refused by name") {
  CHECK_THAT(RenderOptions{.samples = 0}.fault(), Catch::StartsWith("samples:"));
  CHECK_THAT(RenderOptions{.samples = 65537}.fault(), Catch::StartsWith("samples:"));
  CHECK_THAT(RenderOptions{.max_shaded_vertices = 0}.fault(), Catch::StartsWith("max_shaded_vertices:"));
  CHECK(RenderOptions{}.fault().empty());
}
