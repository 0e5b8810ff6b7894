#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "renderer/cache/light_cache.h"
#include "scenes/rig.h"
#include "tests/renderer/estimates.h"
#include "tests/same_bytes.h"

using namespace cps;
using namespace cps::handmade;

namespace {

constexpr int cached_vertices = 5;

/// A scene, lit, with a cache.
struct Cached {
  Scene scene;
  RenderScene lit;
  LightCache cache;

  Cached(const Scene& scene, SkyAndSun light, LightCacheOptions options = {})
      : scene(scene), lit(scene, std::move(light)), cache(scene, lit, cached_vertices, options) {}

  OIIO::ImageBuf picture(const Camera& view, int samples, std::uint64_t seed = 0) {
    return render(lit, view, {.samples = samples, .seed = seed, .cache = &cache});
  }
  OIIO::ImageBuf traced(const Camera& view, int samples, std::uint64_t seed = 0) const {
    return render(lit, view, {.samples = samples, .seed = seed});
  }
};

/// Largest relative difference of the channels' means.
double mean_difference(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b) {
  return (mean(a) / mean(b) - 1).abs().maxCoeff();
}

Mesh ground(int material = 0) {
  return quad({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, material);
}

/// A street between two walls, with a step along one of them and a lamp over it; one wall shines.
Scene street() {
  Scene scene;
  Material steel = material({0.8f, 0.7f, 0.5f, 1}, 1, 0.4f);
  scene.materials = {material({0.3f, 0.3f, 0.3f, 1}, 0, 0.7f), lambert({0.7f, 0.3f, 0.2f, 1}),
                     lambert({0.5f, 0.6f, 0.7f, 1}), steel, lamp({40, 30, 20})};
  for (Material& m : scene.materials) m.double_sided = true;
  add(scene, ground());
  add(scene, quad({-4, 0, -40}, {0, 0, 80}, {0, 7, 0}, 1));
  add(scene, quad({4, 0, 40}, {0, 0, -80}, {0, 5, 0}, 2));
  add(scene, quad({2.5f, 0.3f, 40}, {1.5f, 0, 0}, {0, 0, -80}, 2));
  add(scene, quad({2.5f, 0, 40}, {0, 0.3f, 0}, {0, 0, -80}, 2));
  add(scene, sphere(0.7f, 3), Eigen::Affine3f(Eigen::Translation3f(-1, 0.7f, -2)));
  add(scene, quad({-1, 4, -6}, {0.5f, 0, 0}, {0, 0, 0.5f}, 4));
  return scene;
}

SkyAndSun high_sun() {
  return make_sky_and_sun({.sun_elevation_deg = 50, .sun_azimuth_deg = 120});
}

Camera down_the_street(int width = 96, int height = 64) {
  return camera({1, 1.65, 10}, {0, 1, 0}, width, height, 80);
}

}  // namespace

TEST_CASE("under the same light from everywhere, cached light is that light, whatever the material") {
  for (const float roughness : {0.1f, 0.5f, 1.0f})
    for (const float metallic : {0.0f, 1.0f}) {
      Cached flat(scene_of(material({0.5f, 0.5f, 0.5f, 1}, metallic, roughness), ground()),
                  constant_light(2));
      const Camera view = camera({0, 3, 4}, {0, 0, 0}, 24, 16, 50);
      CHECK(mean_difference(flat.picture(view, 64), flat.traced(view, 256)) < 0.004);
    }
  Cached paper(scene_of(lambert({0.5f, 0.5f, 0.5f, 1}), ground()), constant_light(2));
  const OIIO::ImageBuf image = paper.picture(camera({0, 3, 4}, {0, 0, 0}, 24, 16, 50), 1);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x) REQUIRE(pixel(image, x, y).x() == Approx(1).epsilon(1e-4));
}

TEST_CASE("cached and traced light agree in a street with sun, sky, lamp, steps and steel") {
  Cached made(street(), high_sun());
  const Camera view = down_the_street();
  const OIIO::ImageBuf cached = made.picture(view, 256), traced = made.traced(view, 1024, 1);
  CHECK(mean_difference(cached, traced) < 0.005);
  // Blocks of 8 × 8 pixels, each within a few of its standard errors and the cells' own error.
  for (int y = 0; y < 64; y += 8)
    for (int x = 0; x < 96; x += 8) {
      Color a = Color::Zero(), b = Color::Zero();
      for (int k = 0; k < 64; ++k) {
        a += pixel(cached, x + k % 8, y + k / 8) / 64;
        b += pixel(traced, x + k % 8, y + k / 8) / 64;
      }
      CAPTURE(x, y, a.transpose(), b.transpose());
      CHECK((a / b - 1).abs().maxCoeff() < 0.08f);
    }
}

TEST_CASE("a floor beside a wall is darkened as form factors say") {
  // A black wall without end along z, and of height h: at distance x from it the floor keeps the share
  // (1 + x / √(x² + h²)) / 2 of the sky's light. Beside the low wall light changes within the smallest cells.
  struct Wall {
    float height;
    std::vector<double> distances;
  };
  for (const Wall& wall : {Wall{6, {0.05, 0.3, 1, 3, 10}}, Wall{0.2f, {0.02, 0.1}}}) {
    Scene scene;
    scene.materials = {lambert({1, 1, 1, 1}), lambert({0, 0, 0, 1})};
    add(scene, quad({-400, 0, 400}, {800, 0, 0}, {0, 0, -800}, 0));
    add(scene, quad({0, 0, 400}, {0, 0, -800}, {0, wall.height, 0}, 1));
    scene.materials[1].double_sided = true;
    Cached made(scene, constant_light(1));
    for (const double x : wall.distances) {
      CAPTURE(wall.height, x);
      const Camera view = camera({x, 1.5, 0.3}, {x, 0, 0}, 8, 8, 0.3);
      const Estimate seen = estimate(32, [&](int seed) { return mean(made.picture(view, 16, seed)); });
      const double expected = 0.5 * (1 + x / std::hypot(x, wall.height));
      CHECK(seen.mean[0] == Approx(expected).epsilon(0.04));
    }
  }
}

TEST_CASE("light stays on its side of a wall without thickness") {
  Scene scene;
  scene.materials = {lambert({0.8f, 0.8f, 0.8f, 1})};
  scene.materials[0].double_sided = true;
  const Vec3 size(6, 3, 6), low(-3, 0, -3);
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {0.0f, 1.0f}) {
      Vec3 corner = low, a = Vec3::Zero(), b = Vec3::Zero();
      corner[axis] += side * size[axis];
      a[(axis + 1) % 3] = size[(axis + 1) % 3];
      b[(axis + 2) % 3] = size[(axis + 2) % 3];
      add(scene, quad(corner, a, b));
    }
  Cached room(scene, constant_light(1));
  for (const Eigen::Vector3d& at :
       {Eigen::Vector3d(1, 1, -3), Eigen::Vector3d(3, 2, 1), Eigen::Vector3d(-1, 0, 2)})
    CHECK(mean(room.picture(camera({0, 1.5, 0.2}, at, 32, 32, 100), 4)).maxCoeff() == 0);
  // From outside it is as bright as paper under that sky.
  const OIIO::ImageBuf outside = room.picture(camera({0, 1.5, 9}, {0, 1.5, 0}, 16, 16, 5), 16);
  CHECK(mean(outside).x() == Approx(0.8).epsilon(0.02));
}

TEST_CASE("a small hut is dark inside on ground that is lit outside") {
  // Cells of the ground reach through the walls: of the cells that the camera sees, and of the larger ones
  // that paths meet less than two cells away, no light may be taken here.
  Scene scene;
  scene.materials = {lambert({0.8f, 0.8f, 0.8f, 1})};
  scene.materials[0].double_sided = true;
  add(scene, ground());
  for (const float side : {-1.0f, 1.0f}) {
    add(scene, quad({side, -0.1f, -1.1f}, {0, 0, 2.2f}, {0, 2.2f, 0}));
    add(scene, quad({-1.1f, -0.1f, side}, {2.2f, 0, 0}, {0, 2.2f, 0}));
  }
  add(scene, quad({-1.1f, 2, -1.1f}, {2.2f, 0, 0}, {0, 0, 2.2f}));
  Cached hut(scene, constant_light(1));
  // One path in millions may slip between two triangles.
  CHECK(mean(hut.picture(camera({0, 1.8, 0.2}, {0.3, 0, 0.1}, 16, 16, 100), 4)).maxCoeff() < 0.004f);
  CHECK(mean(hut.picture(camera({0, 1, 0.2}, {1, 0.5, -0.3}, 16, 16, 100), 4)).maxCoeff() < 0.004f);
}

TEST_CASE("a marking just above the road is as bright as the road's light makes it") {
  Scene scene;
  scene.materials = {lambert({0.1f, 0.1f, 0.1f, 1}), lambert({0.8f, 0.8f, 0.8f, 1})};
  add(scene, ground(0));
  add(scene, quad({-0.1f, 0.012f, 40}, {0.2f, 0, 0}, {0, 0, -80}, 1));
  Cached road(scene, constant_light(1));
  const OIIO::ImageBuf image = road.picture(camera({0, 4, 0.1}, {0, 0, 0}, 32, 32, 2), 16);
  CHECK(pixel(image, 16, 16).x() == Approx(0.8).epsilon(0.01));
  const OIIO::ImageBuf beside = road.picture(camera({0.5, 4, 0.1}, {0.5, 0, 0}, 32, 32, 2), 16);
  CHECK(mean(beside).x() == Approx(0.1).epsilon(0.01));
}

TEST_CASE("cached pictures have the same bytes for any threads, order of views and memory") {
  const Camera first = down_the_street(), second = camera({-2, 3, -20}, {0, 1, 5}, 64, 48, 60);
  Cached reference(street(), high_sun());
  const OIIO::ImageBuf expected = reference.picture(first, 2, 3);
  REQUIRE(reference.cache.summary().cells > 1000);
  for (const int threads : {1, 2, 16}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Cached again(street(), high_sun());
    CHECK(same_bytes(again.picture(first, 2, 3), expected));
  }
  Cached other_order(street(), high_sun());
  other_order.picture(second, 1, 8);
  CHECK(same_bytes(other_order.picture(first, 2, 3), expected));
  Cached forgetful(street(), high_sun(), {.memory_gib = 1e-5});
  CHECK(forgetful.cache.summary().cells == 0);
  const Camera small = down_the_street(24, 16);
  CHECK(same_bytes(forgetful.picture(small, 1, 3), reference.picture(small, 1, 3)));
  CHECK(forgetful.cache.summary().cells < 1000);
  reference.cache.make_room();  // far from full: keeps all
  CHECK(reference.cache.summary().cells > 1000);
}

TEST_CASE("a cache keeps no more cells than its memory holds and forgets them when it is full") {
  // Seen from high above every pixel asks for a cell of its own.
  const Scene open = scene_of(lambert({0.5f, 0.5f, 0.5f, 1}), ground());
  const Camera high = camera({0, 30, 0.1}, {0, 0, 0}, 24, 24, 60);
  Cached large(open, constant_light(1));
  Cached small(open, constant_light(1), {.memory_gib = 2e-6});
  CHECK(same_bytes(large.picture(high, 1), small.picture(high, 1)));
  CHECK(large.cache.summary().cells > 300);
  CHECK(small.cache.summary().cells > 10);
  CHECK(small.cache.summary().cells < 100);  // about 30, and one for each thread
  small.cache.make_room();
  CHECK(small.cache.summary().cells == 0);
}

TEST_CASE("what rides with the car shades the road where it is, and leaves nothing in the cache") {
  Scene scene;
  scene.materials = {lambert({0.5f, 0.5f, 0.5f, 1})};
  scene.meshes = {ground(), sphere(0.5f)};
  scene.instances = {
      {.mesh = 0},
      {.mesh = 1, .world_from_mesh = Eigen::Affine3f(Eigen::Translation3f(0, 0, 0.7f)), .rides = true}};
  Cached made(scene, constant_light(1));
  const auto below_car = [&](double x) {
    put_car(made.lit, world_from_vehicle(Place{.position = {x, 0, 0}}));
    const Camera view = camera({x - 2, 1, 0.01}, {x, 0, 0}, 8, 8, 1);
    const Estimate seen = estimate(32, [&](int seed) { return mean(made.picture(view, 64, seed)); });
    const Estimate traced = estimate(32, [&](int seed) { return mean(made.traced(view, 64, seed)); });
    CHECK(standard_errors_off(seen, traced.mean, 0.01) < max_standard_errors);
    return seen.mean[0];
  };
  const double shaded = below_car(0);
  CHECK(shaded < 0.45);
  CHECK(below_car(12) == Approx(shaded).epsilon(0.02));
  // Where the car was, the road is in full light.
  put_car(made.lit, world_from_vehicle(Place{.position = {30, 0, 0}}));
  CHECK(mean(made.picture(camera({-2, 1, 0.01}, {0, 0, 0}, 8, 8, 1), 16)).x() == Approx(0.5).epsilon(0.01));
}

TEST_CASE("normal maps and smooth normals show in cached light") {
  // A facetted ball with smooth normals under a sky that is bright overhead.
  Scene scene;
  scene.materials = {lambert({0.5f, 0.5f, 0.5f, 1})};
  add(scene, sphere(6, 0, 12));
  Cached ball(scene, make_sky_and_sun({.sky = SkyModel::overcast}));
  const Camera view = camera({0, 2, 20}, {0, 0, 0}, 32, 32, 30);
  const OIIO::ImageBuf cached = ball.picture(view, 64), traced = ball.traced(view, 256);
  double squares = 0, count = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      squares += std::pow(pixel(cached, x, y).y() / pixel(traced, x, y).y() - 1, 2);
      ++count;
    }
  CHECK(std::sqrt(squares / count) < 0.03);
}

TEST_CASE("options of the cache are checked") {
  CHECK(LightCacheOptions{}.fault().empty());
  CHECK_FALSE(LightCacheOptions{.memory_gib = 0}.fault().empty());
  CHECK_FALSE(LightCacheOptions{.memory_gib = std::nan("")}.fault().empty());
}
