#include <catch2/catch.hpp>

#include "scenes/places/clearance.h"
#include "tests/scenes/box.h"

using namespace cps;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

/// A slab whose top is the ground at y = 0, and a 10 m cube as a house, its west wall at x = 15.
Scene house_on_the_ground(float mirror = 1) {
  Scene scene;
  scene.materials.resize(1);
  scene.meshes = {box()};
  Instance ground, house;
  ground.world_from_mesh = Eigen::Translation3f(0, -1, 0) * Eigen::Scaling(Vector3f(200 * mirror, 1, 200));
  house.world_from_mesh = Eigen::Translation3f(20, 5, 0) * Eigen::Scaling(Vector3f(5 * mirror, 5, 5));
  scene.instances = {ground, house};
  return scene;
}

const Vector3d east(1, 0, 0), west(-1, 0, 0);

}  // namespace

TEST_CASE("a place has no fault unless something is close ahead") {
  const SceneRays query(house_on_the_ground());
  CHECK(clearance_fault(query, {0, 1.65, 0}, east, 5) == PlaceFault::none);
  CHECK(clearance_fault(query, {9.9, 1.65, 0}, east, 5) == PlaceFault::none);
  CHECK(clearance_fault(query, {10.3, 1.65, 0}, east, 5) == PlaceFault::too_close);
  CHECK(clearance_fault(query, {10.3, 1.65, 0}, west, 5) == PlaceFault::none);  // it is behind
  CHECK(clearance_fault(query, {10.3, 1.65, 0}, 7 * east, 4) == PlaceFault::none);
}

TEST_CASE("a place inside something or below the ground is a fault") {
  const float mirror = GENERATE(1.0f, -1.0f);  // front faces of mirrored instances stay front faces
  const SceneRays query(house_on_the_ground(mirror));
  CHECK(clearance_fault(query, {0, 1.65, 0}, east, 0) == PlaceFault::none);
  CHECK(clearance_fault(query, {20, 5, 0}, east, 0) == PlaceFault::inside);
  CHECK(clearance_fault(query, {0, -0.5, 0}, east, 0) == PlaceFault::inside);
}

TEST_CASE("double-sided surfaces around the camera do not count as being inside") {
  Scene scene = house_on_the_ground();
  scene.materials[0].double_sided = true;
  CHECK(clearance_fault(SceneRays(scene), {20, 5, 0}, east, 1) == PlaceFault::none);
}

TEST_CASE("a camera that sees only sky is a fault") {
  const SceneRays rays(house_on_the_ground());
  CHECK(clearance_fault(rays, {0, 1.65, 0}, {0, 1, 0}, 1) == PlaceFault::only_sky);
  CHECK(clearance_fault(rays, {0, 1.65, 0}, {-1, 1.2, 0}, 1) == PlaceFault::only_sky);
  CHECK(clearance_fault(rays, {0, 1.65, 0}, {-1, 0.1, 0}, 1) == PlaceFault::none);  // open ground is a view
}
