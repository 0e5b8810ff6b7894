#include <tbb/parallel_for.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "random/counter_hash.h"
#include "renderer/paths/surface.h"
#include "tests/renderer/estimates.h"

using namespace cps;
using namespace cps::handmade;

namespace {

constexpr int width = 12, height = 8, max_shaded_vertices = 3;

/// A room open to the sky: matt floor, glossy and coated walls, a lamp, a pane of glass, a masked screen.
Scene everything() {
  Scene scene;
  Material coated = material({0.5f, 0.1f, 0.1f, 1}, 0, 0.8f);
  coated.clearcoat = 1;
  coated.clearcoat_roughness = 0.4f;
  Material screen = lambert({0.7f, 0.7f, 0.7f, 0.5f});
  screen.alpha_mode = AlphaMode::blend;
  scene.materials = {lambert({0.6f, 0.5f, 0.4f, 1}),
                     material({0.8f, 0.7f, 0.5f, 1}, 1, 0.5f),
                     coated,
                     lamp({2, 4, 6}),
                     glass({0.6f, 0.9f, 0.7f, 1}),
                     screen};
  for (Material& m : scene.materials) m.double_sided = true;
  add(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0));
  add(scene, quad({-2, 0, -2}, {4, 0, 0}, {0, 2, 0}, 1));
  add(scene, quad({-2, 0, 2}, {0, 0, -4}, {0, 2, 0}, 2));
  add(scene, quad({0.8f, 1.2f, -1.5f}, {1, 0, 0}, {0, 0, 2}, 3));
  add(scene, quad({-1, 0.1f, 0.5f}, {1.4f, 0, 0.2f}, {0, 1, 0}, 4));
  add(scene, quad({0.6f, 0.1f, -0.5f}, {0.8f, 0, 0.3f}, {0, 0.8f, 0}, 5));
  return scene;
}

SkyAndSun overcast_with_a_wide_sun() {
  const Daylight daylight{.sun_elevation_deg = 50, .sun_azimuth_deg = 100, .sky = SkyModel::overcast};
  return {make_overcast_sky(daylight), make_sun(direction_to_sun(daylight), 0.5, Color(8, 6, 4))};
}

/// Uniform numbers of one path.
struct Numbers {
  Stream stream;
  std::uint64_t used = 0;
  float next() { return 0x1p-24f * static_cast<float>(random_bits(stream, used++) >> 40); }
};

/// The same light transport without samples of lamps, sun or sky, weights, roulette or packets: paths find
/// light only where their BSDFs happen to send them.
Color trace_by_bsdf_alone(const RenderScene& scene, Ray ray, Numbers& numbers) {
  Color radiance = Color::Zero(), throughput = Color::Ones();
  float min_roughness = 0;
  for (int shaded = 0;;) {
    ray.id = static_cast<std::uint32_t>(random_bits(numbers.stream, numbers.used++));
    const Hit hit = scene.bvh.intersect(ray);
    if (!hit) {
      Color beyond = scene.sky.radiance(ray.direction);
      if (scene.sun.covers(ray.direction)) beyond += scene.sun.radiance;
      return radiance + throughput * beyond;
    }
    const Surface surface = make_surface(scene.placed, ray, hit, 0, min_roughness);
    radiance += throughput * surface.emission;
    if (shaded == max_shaded_vertices) {
      throughput *= surface.bsdf.straight;
      if ((throughput == 0).all()) return radiance;
      ray = surface.pass(ray);
      continue;
    }
    const float u = numbers.next(), v = numbers.next(), w = numbers.next();
    const BsdfSample sample = sample_bsdf(surface.bsdf, surface.wo, u, {v, w});
    if (sample.kind == BsdfSample::Kind::straight) {
      throughput *= sample.weight;
      ray = surface.pass(ray);
      continue;
    }
    const Vec3 direction = surface.shading.to_world(sample.wi);
    if (!(sample.pdf > 0) || surface.geometric_normal.dot(direction) <= 0) return radiance;
    throughput *= sample.weight;
    const bool matt = sample.kind == BsdfSample::Kind::diffuse;
    const float gloss =
        sample.kind == BsdfSample::Kind::coat ? surface.bsdf.coat.roughness : surface.bsdf.roughness;
    min_roughness = std::max(min_roughness, matt ? 0.6f : 0.5f * gloss);
    ray = surface.leave(direction);
    ++shaded;
  }
}

std::vector<Estimate> reference(const RenderScene& scene, const Camera& view, int samples) {
  std::vector<Estimate> pixels(width * height);
  tbb::parallel_for(0, width * height, [&](int pixel) {
    pixels[pixel] = estimate(samples, [&](int i) {
      Numbers numbers{substream(make_stream(11, "reference"), static_cast<std::uint64_t>(pixel) << 32 | i)};
      const float x = static_cast<float>(pixel % width) - 0.5f + numbers.next();
      const float y = static_cast<float>(pixel / width) - 0.5f + numbers.next();
      const Eigen::Vector3d in_camera((x - view.pinhole.cx) / view.pinhole.fx,
                                      (y - view.pinhole.cy) / view.pinhole.fy, 1);
      Ray ray;
      ray.origin = view.world_from_camera.translation().cast<float>();
      ray.direction = (view.world_from_camera.linear() * in_camera.normalized()).cast<float>();
      return trace_by_bsdf_alone(scene, ray, numbers);
    });
  });
  return pixels;
}

std::vector<Estimate> rendered(const RenderScene& scene, const Camera& view, int images, int samples) {
  std::vector<OIIO::ImageBuf> all;
  for (int i = 0; i < images; ++i) {
    all.push_back(render(scene, view,
                         {.samples = samples,
                          .max_shaded_vertices = max_shaded_vertices,
                          .seed = static_cast<std::uint64_t>(i)}));
  }
  std::vector<Estimate> pixels;
  for (int p = 0; p < width * height; ++p)
    pixels.push_back(estimate(images, [&](int i) { return pixel(all[i], p % width, p / width); }));
  return pixels;
}

/// Smallest probability, over all pixels and channels, that two estimates of the same quantity differ by as
/// much as these.
double min_p_value(const std::vector<Estimate>& a, const std::vector<Estimate>& b) {
  double min = 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double z = (a[i].mean[c] - b[i].mean[c]) / std::sqrt(a[i].variance[c] + b[i].variance[c]);
      min = std::min(min, std::erfc(std::abs(z) / std::sqrt(2.0)));
    }
  }
  return min;
}

/// Significance level of each of `tests` for which all together have the level `all` (Šidák 1967).
double sidak(double all, double tests) {
  return 1 - std::pow(1 - all, 1 / tests);
}

}  // namespace

TEST_CASE("Every pixel agrees with BSDF sampling alone: glass, coats, lamps, sky and sun together") {
  const RenderScene scene(everything(), overcast_with_a_wide_sun());
  const Camera view = camera({0.6, 1.1, 3.2}, {-0.1, 0.5, 0}, width, height, 60);
  CHECK(min_p_value(rendered(scene, view, 64, 16), reference(scene, view, 4000)) >
        sidak(0.001, 3 * width * height));
}

TEST_CASE("The same with forty times the samples", "[slow]") {
  const RenderScene scene(everything(), overcast_with_a_wide_sun());
  const Camera view = camera({0.6, 1.1, 3.2}, {-0.1, 0.5, 0}, width, height, 60);
  const std::vector<Estimate> seen = rendered(scene, view, 64, 512), exact = reference(scene, view, 160000);
  CHECK(min_p_value(seen, exact) > sidak(0.001, 3 * width * height));
  double difference = 0, light = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    difference += (seen[i].mean - exact[i].mean).sum();
    light += exact[i].mean.sum();
  }
  CHECK(std::abs(difference / light) < 0.002);
}
