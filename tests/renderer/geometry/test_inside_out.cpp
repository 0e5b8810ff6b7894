#include <catch2/catch.hpp>

#include "scenes/inside_out.h"
#include "tests/renderer/handmade.h"

using namespace cps;
using namespace cps::handmade;

namespace {

Mesh turned_inside_out(Mesh mesh) {
  for (Eigen::Vector3i& triangle : mesh.triangles) std::swap(triangle.y(), triangle.z());
  for (Eigen::Vector3f& normal : mesh.normals) normal = -normal;
  return mesh;
}

}  // namespace

TEST_CASE("Only a nearly closed shell that faces inwards is inside out") {
  CHECK(is_inside_out(turned_inside_out(sphere(2))));
  CHECK_FALSE(is_inside_out(sphere(2)));
  CHECK_FALSE(is_inside_out(quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1})));
  // A bowl faces inwards too, but it is open: a valley, not a hull.
  Mesh bowl = turned_inside_out(sphere(2, 0, 8));
  std::erase_if(bowl.triangles, [&](const Eigen::Vector3i& t) { return bowl.positions[t.x()].y() > 0.1f; });
  CHECK_FALSE(is_inside_out(bowl));
  // So is a finely meshed one, whose rim is a small share of its edges.
  Mesh valley = turned_inside_out(sphere(2, 0, 200));
  std::erase_if(valley.triangles,
                [&](const Eigen::Vector3i& t) { return valley.positions[t.x()].y() > -1.0f; });
  CHECK_FALSE(is_inside_out(valley));
}

// The outline hulls of cartoon-style models once left everything inside them black.
TEST_CASE("A shell turned inside out shows its far side and keeps no light from what is inside") {
  const Vec3 to_sun = Vec3(0.2f, 1, 0.1f).normalized();
  const Camera from_outside = camera({0, 6, 8}, {0, 0, 0}, 16, 16, 0.2);
  Scene plain = scene_of(material({0.6f, 0.5f, 0.4f, 1}), quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}));
  Scene hulled = plain;
  hulled.materials.push_back(material({0, 0, 0, 1}));
  Mesh hull = turned_inside_out(sphere(3, 1));
  add(hulled, hull);
  const SkyAndSun light = sun_only(to_sun, Color::Constant(10));
  const Color bare = mean(render(RenderScene(plain, light), from_outside, {.samples = 64}));
  const Color inside = mean(render(RenderScene(hulled, light), from_outside, {.samples = 64}));
  CHECK(bare.minCoeff() > 0.5f);
  CHECK((inside / bare - 1).abs().maxCoeff() < 0.01f);
  // Looking past the square, the hull's far side hides the sky.
  const Camera past = camera({0, 6, 8}, {0, 2.2, 0}, 8, 8, 0.02);
  CHECK(mean(render(RenderScene(hulled, constant_light(1)), past, {.samples = 16})).maxCoeff() < 0.2f);
}
