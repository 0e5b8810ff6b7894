#include <catch2/catch.hpp>
#include <cmath>

#include "random/counter_hash.h"
#include "renderer/lights/lamps.h"
#include "renderer/math/sobol.h"
#include "tests/renderer/handmade.h"
#include "tests/renderer/statistics.h"

using namespace cps;
using namespace cps::handmade;

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;
const Color albedo(0.6f, 0.4f, 0.2f);

/// A Lambert floor around the origin.
Scene floor() {
  return scene_of(lambert({albedo.x(), albedo.y(), albedo.z(), 1}),
                  quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}));
}

PunctualLight light(PunctualLight::Kind kind, const Vec3& position, const Vec3& direction) {
  PunctualLight l;
  l.kind = kind;
  l.position = position;
  l.direction = direction.normalized();
  l.intensity = {1, 2, 3};
  return l;
}

/// Illuminance of the floor at the origin, from the floor's radiance there.
Color illuminance(const Scene& scene, int samples = 64) {
  const RenderScene built(scene, no_light());
  const Camera view = camera({0, 3, 4}, {0, 0, 0}, 8, 8, 0.01);
  return mean(render(built, view, {.samples = samples, .max_shaded_vertices = 1})) * pi_f / albedo;
}

double worst(const Color& seen, const Color& exact) {
  return (seen / exact - 1).abs().maxCoeff();
}

/// Illuminance of a surface at the origin facing up by a polygon of radiance 1 above it, whose corners run
/// clockwise seen from below (Lambert 1760).
double polygon_illuminance(const std::vector<Eigen::Vector3d>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d a = corners[i].normalized(), b = corners[(i + 1) % corners.size()].normalized();
    sum += std::acos(a.dot(b)) * a.cross(b).normalized().y();
  }
  return std::abs(sum) / 2;
}

/// Many small lamps of every kind and strength over the floor.
Scene many_lamps(int count) {
  Scene scene = floor();
  const Stream stream = make_stream(7, "lamps");
  for (int i = 0; i < count; ++i) {
    const Stream s = substream(stream, static_cast<std::uint64_t>(i));
    const auto draw = [&](int k, double low, double high) {
      return static_cast<float>(random_uniform(s, static_cast<std::uint64_t>(k), low, high));
    };
    const Vec3 place(draw(0, -15, 15), draw(1, 1, 5), draw(2, -15, 15));
    if (i % 3 == 0) {
      scene.lights.push_back(light(i % 2 ? PunctualLight::Kind::point : PunctualLight::Kind::spot, place,
                                   {draw(3, -1, 1), -1, draw(4, -1, 1)}));
      scene.lights.back().cos_inner = 0.9f;
      scene.lights.back().cos_outer = 0.5f;
      scene.lights.back().intensity *= draw(5, 0, 0.2);
    } else {
      scene.materials.push_back(lamp(Vec3(1, 2, 3) * draw(3, 0, 100)));
      scene.materials.back().double_sided = i % 2;
      add(scene, quad(place, {draw(4, -0.1, 0.1), draw(5, -0.1, 0.1), 0.06f},
                      {0.04f, draw(6, -0.1, 0.1), draw(7, -0.1, 0.1)},
                      static_cast<int>(scene.materials.size()) - 1));
    }
  }
  return scene;
}

}  // namespace

TEST_CASE("A point light lights the floor by its intensity over the squared distance") {
  Scene scene = floor();
  scene.lights = {light(PunctualLight::Kind::point, {1, 2, -1}, {0, 0, 1})};
  const float d2 = 6;
  CHECK(worst(illuminance(scene), Color(1, 2, 3) / d2 * (2 / std::sqrt(d2))) < 1e-3);
}

TEST_CASE("A spot light is full within its inner cone and fades to nothing at its outer one") {
  for (float angle_deg : {0.0f, 15.0f, 25.0f, 29.0f, 31.0f}) {
    CAPTURE(angle_deg);
    Scene scene = floor();
    const float a = angle_deg * pi_f / 180;
    scene.lights = {light(PunctualLight::Kind::spot, {0, 2, 0}, {std::sin(a), -std::cos(a), 0})};
    scene.lights[0].cos_inner = std::cos(20 * pi_f / 180);
    scene.lights[0].cos_outer = std::cos(30 * pi_f / 180);
    const float range = scene.lights[0].cos_inner - scene.lights[0].cos_outer;
    const float t = std::clamp((std::cos(a) - scene.lights[0].cos_outer) / range, 0.0f, 1.0f);
    CHECK((illuminance(scene) - Color(1, 2, 3) / 4 * t * t).abs().maxCoeff() < 2e-3f);
  }
}

TEST_CASE("A directional light lights by its illuminance and the cosine, and casts shadows") {
  Scene scene = floor();
  scene.lights = {light(PunctualLight::Kind::directional, {0, 0, 0}, {0.5f, -0.7f, 0.2f}),
                  light(PunctualLight::Kind::directional, {0, 0, 0}, {0, -1, 0})};
  scene.lights[1].intensity = {3, 3, 3};
  const float cosine = -scene.lights[0].direction.y();
  CHECK(worst(illuminance(scene, 4096), Color(1, 2, 3) * cosine + 3) < 0.01);
  scene.materials.push_back(lambert({0, 0, 0, 1}));
  add(scene, quad({-0.5f, 2, 0.5f}, {1, 0, 0}, {0, 0, -1}, 1));  // shades the vertical light
  CHECK(worst(illuminance(scene, 4096), Color(1, 2, 3) * cosine) < 0.01);
}

TEST_CASE("An emissive rectangle lights the floor as Lambert's formula for polygons says") {
  const Vec3 corner(-0.5f, 1, 0.4f), a(1.5f, 0.4f, 0), b(0, -0.3f, -1);
  const Mesh lit = quad(corner, b, a, 1);  // faces down
  const double exact = polygon_illuminance({corner.cast<double>(), (corner + a).cast<double>(),
                                            (corner + a + b).cast<double>(), (corner + b).cast<double>()});
  for (bool shared : {false, true}) {
    Scene scene = floor();
    scene.materials.push_back(lamp({1, 2, 3}));
    if (!shared) {
      add(scene, lit);
    } else {  // one of two instances, mirrored and turned; the other one is far away
      Mesh mesh = lit;
      mesh.positions.clear();
      mesh.triangles.clear();
      constexpr int cells = 60;  // too many to be flattened
      for (int i = 0; i < (cells + 1) * (cells + 1); ++i) {
        mesh.positions.push_back(corner + a * (static_cast<float>(i / (cells + 1)) / cells) +
                                 b * (static_cast<float>(i % (cells + 1)) / cells));
      }
      for (int i = 0; i < cells * (cells + 1); ++i) {
        if (i % (cells + 1) == cells) continue;
        const int next = i + cells + 1;  // wound for the mirror, which turns it back
        mesh.triangles.push_back({i, next + 1, i + 1});
        mesh.triangles.push_back({i, next, next + 1});
      }
      mesh.normals.assign(mesh.positions.size(), lit.normals[0]);
      mesh.uv0.assign(mesh.positions.size(), Eigen::Vector2f::Zero());
      mesh.tangents.clear();
      Eigen::Affine3f place(Eigen::Translation3f(1, 0.5f, 0) * Eigen::AngleAxisf(1, Vec3::UnitY()) *
                            Eigen::Scaling(-1.0f, 1.0f, 1.0f));
      for (Vec3& p : mesh.positions) p = place.inverse() * p;
      for (Vec3& n : mesh.normals) n = (place.inverse().linear() * n).normalized();
      add(scene, mesh, place);
      scene.instances.push_back(scene.instances.back());
      scene.instances.back().world_from_mesh.pretranslate(Vec3(0, 1e5f, 0));
      scene.instances.push_back(scene.instances.back());
      scene.instances.push_back(scene.instances.back());
      REQUIRE(RenderScene(scene, no_light()).placed.placements[1].shared);
    }
    CAPTURE(shared);
    CHECK(worst(illuminance(scene, 2048), Color(1, 2, 3) * static_cast<float>(exact)) < 0.01);
  }
}

TEST_CASE("Only the front of a single-sided lamp shines") {
  for (bool double_sided : {false, true}) {
    Scene scene = floor();
    scene.materials.push_back(lamp({1, 1, 1}));
    scene.materials[1].double_sided = double_sided;
    add(scene, quad({-1, 2, 1}, {2, 0, 0}, {0, 0, -2}, 1));  // its front sees the sky
    const double exact = polygon_illuminance({{-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1}});
    CHECK(illuminance(scene, 1024).x() == Approx(double_sided ? exact : 0).epsilon(0.01));
  }
}

TEST_CASE("An emissive texture's lit half lights the floor, its masked half does not") {
  Texture half;
  half.name = "half";
  half.width = 2;
  half.height = 1;
  half.nearest = true;
  half.wrap_u = Wrap::clamp_to_edge;
  Scene scene = floor();
  scene.materials.push_back(lamp({1, 1, 1}));
  const Vec3 corner(-1, 2, 1), a(0, 0, -2), b(2, 0, 0);
  add(scene, quad(corner, a, b, 1));  // u runs to −z
  const double whole = polygon_illuminance({{-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1}});
  SECTION("by emission") {
    half.rgba = {0, 0, 0, 255, 255, 255, 255, 255};
    scene.materials[1].emissive_texture.texture = 0;
  }
  SECTION("by alpha") {
    half.rgba = {255, 255, 255, 0, 255, 255, 255, 255};
    scene.materials[1].base_color = {1, 1, 1, 1};
    scene.materials[1].base_color_texture.texture = 0;
    scene.materials[1].alpha_mode = AlphaMode::mask;
  }
  scene.textures = {half};
  CHECK(illuminance(scene, 4096).x() == Approx(whole / 2).epsilon(0.015));
}

TEST_CASE("The lamps' probabilities add up to one, and lamps are chosen by them") {
  const Scene scene = many_lamps(200);
  const RenderScene built(scene, no_light());
  const LampTree& tree = built.lamps.tree;
  const auto lamps = static_cast<std::uint32_t>(built.lamps.emitters.size());
  for (int i = 0; i < 40; ++i) {
    const Stream s = substream(make_stream(8, "points"), static_cast<std::uint64_t>(i));
    const Vec3 point(static_cast<float>(random_uniform(s, 0, -15, 15)),
                     static_cast<float>(random_uniform(s, 1, 0, 6)),
                     static_cast<float>(random_uniform(s, 2, -15, 15)));
    const Vec3 normal = direction_at(static_cast<float>(random_uniform(s, 3)),
                                     static_cast<float>(random_uniform(s, 4, -1, 1)));
    std::vector<double> expected(lamps), observed(lamps);
    double sum = 0;
    constexpr int draws = 20000;
    for (std::uint32_t lamp = 0; lamp < lamps; ++lamp) {
      const double p = tree.probability(point, normal, lamp);
      sum += p;
      expected[lamp] = draws * p;
    }
    for (int k = 0; k < draws; ++k) {
      const float u = static_cast<float>(random_uniform(s, 100 + static_cast<std::uint64_t>(k)));
      const LampTree::Choice choice = tree.choose(point, normal, u);
      if (!(choice.probability > 0)) continue;
      ++observed[choice.lamp];
      REQUIRE(choice.probability == Approx(tree.probability(point, normal, choice.lamp)).epsilon(1e-4));
    }
    CHECK(sum < 1.0001);
    for (std::uint32_t lamp = 0; lamp < lamps; ++lamp) {
      if (expected[lamp] == 0) CHECK(observed[lamp] == 0);
    }
    if (sum > 0.9999) CHECK(chi_squared_p_value(observed, expected) > 1e-4 / 40);
  }
}

TEST_CASE("Light of many lamps adds up, and each is found however the others shine") {
  // One at a time, in closed form, against all together by the tree.
  Scene scene = many_lamps(90);
  Color exact = Color::Zero();
  for (const PunctualLight& l : scene.lights) {
    const Vec3 to_light = l.position;
    const float d2 = to_light.squaredNorm();
    float share = 1;
    if (l.kind == PunctualLight::Kind::spot) {
      const float t = std::clamp((l.direction.dot(-to_light.normalized()) - 0.5f) / 0.4f, 0.0f, 1.0f);
      share = t * t;
    }
    exact += l.intensity.array() * share * to_light.normalized().y() / d2;
  }
  for (std::size_t m = 1; m < scene.meshes.size(); ++m) {
    const Mesh& mesh = scene.meshes[m];
    const Material& material = scene.materials[mesh.material];
    if (!material.double_sided && mesh.normals[0].dot(-mesh.positions[0]) <= 0) continue;
    std::vector<Eigen::Vector3d> corners;
    for (const Vec3& p : mesh.positions) corners.push_back(p.cast<double>());
    exact += material.emissive.array() * static_cast<float>(polygon_illuminance(corners));
  }
  // The lamps also shade one another; a few small ones do little.
  CHECK(worst(illuminance(scene, 4096), exact) < 0.03);
}

TEST_CASE("Lamps alone, BSDF alone and both together agree on a glossy surface") {
  const Vec3 corner(-0.4f, 0.8f, -1.2f), a(0.9f, 0, 0), b(0, 0.6f, 0.3f);
  for (float roughness : {0.15f, 0.4f, 0.9f}) {
    CAPTURE(roughness);
    Scene scene = scene_of(material({0.9f, 0.7f, 0.5f, 1}, 0.5f, roughness),
                           quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}));
    scene.materials.push_back(lamp({1, 2, 3}));
    scene.materials[1].double_sided = true;
    add(scene, quad(corner, a, b, 1));
    const RenderScene built(scene, no_light());
    const Vec3 to_eye(0, 0.6f, 0.8f);
    const auto local = [](const Vec3& v) { return Vec3(v.x(), -v.z(), v.y()); };
    const Bsdf bsdf = make_bsdf({Color(0.9f, 0.7f, 0.5f), 0.5f, roughness}, local(to_eye));
    Eigen::Array3d by_area = Eigen::Array3d::Zero(), by_lamps = by_area, by_bsdf = by_area;
    constexpr int cells = 400, samples = 400000;
    for (int i = 0; i < cells * cells; ++i) {  // quadrature over the lamp
      const Vec3 at = corner + a * ((static_cast<float>(i % cells) + 0.5f) / cells) +
                      b * ((static_cast<float>(i / cells) + 0.5f) / cells);
      const float d2 = at.squaredNorm();
      const float cosine = std::abs(a.cross(b).dot(at)) / std::sqrt(d2);  // times the area
      by_area +=
          (evaluate_bsdf(bsdf, local(to_eye), local(at.normalized())).f_cos * Color(1, 2, 3) * cosine / d2)
              .cast<double>() /
          (cells * cells);
    }
    for (int i = 0; i < samples; ++i) {
      const SobolSample sample = make_sobol_sample(3, 1, 1, static_cast<std::uint32_t>(i));
      const LampSample s =
          built.lamps.sample(built.placed, Vec3::Zero(), Vec3::UnitY(), sample.pair(0).x(), sample.pair(1));
      if (s.pdf > 0) {
        by_lamps +=
            (evaluate_bsdf(bsdf, local(to_eye), local(s.direction)).f_cos * s.light_over_pdf).cast<double>();
        Ray ray;
        ray.direction = s.direction;
        ray.origin = 0.01f * s.direction;
        const Hit hit = built.bvh.intersect(ray);
        if (i < 100 && hit) {  // the density is that of the place hit
          const Vec3 at = ray.origin + hit.t * ray.direction;
          REQUIRE(built.lamps.pdf(built.placed, Vec3::Zero(), Vec3::UnitY(), hit.placement, hit.triangle,
                                  at) == Approx(s.pdf).epsilon(2e-3));
        }
      }
      const BsdfSample d = sample_bsdf(bsdf, local(to_eye), sample.pair(2).x(), sample.pair(3));
      if (!(d.pdf > 0)) continue;
      Ray ray;
      ray.direction = {d.wi.x(), d.wi.z(), -d.wi.y()};
      ray.origin = 1e-4f * Vec3::UnitY();
      const Hit hit = built.bvh.intersect(ray);
      if (hit && hit.placement == 1) by_bsdf += (d.weight * Color(1, 2, 3)).cast<double>();
    }
    const Color exact = by_area.cast<float>();
    CHECK(worst((by_lamps / samples).cast<float>(), exact) < 0.01);
    CHECK(worst((by_bsdf / samples).cast<float>(), exact) < 0.02);
    const Color both = mean(
        render(built, camera({0, 3, 4}, {0, 0, 0}, 8, 8, 0.01), {.samples = 1024, .max_shaded_vertices = 1}));
    CHECK(worst(both, exact) < 0.01);
  }
}

TEST_CASE("A lamp has its own radiance for the eye and in a mirror") {
  Scene scene;
  scene.materials = {material({1, 1, 1, 1}, 1, 0), lamp({5, 6, 7})};
  add(scene, quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}));
  add(scene, quad({-9, 0, -9}, {18, 0, 0}, {0, 18, 0}, 1));
  const RenderScene built(scene, no_light());
  const auto seen = [&](const Eigen::Vector3d& at) {
    return mean(render(built, camera({0, 2, 4}, at, 4, 4, 1), {.samples = 64}));
  };
  CHECK(worst(seen({0, 3, -9}), Color(5, 6, 7)) < 1e-3);
  CHECK(worst(seen({0, 0, 0}), Color(5, 6, 7)) < 0.02);
}
