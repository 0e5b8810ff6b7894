#include <catch2/catch.hpp>
#include <cmath>

#include "scenes/wheels.h"

using namespace cps;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

/// A plane of height y = rise_x · x + rise_z · z.
Scene slope(float rise_x, float rise_z) {
  Scene scene;
  scene.materials.resize(1);
  Mesh ground;
  for (const float x : {-100.0f, 100.0f})
    for (const float z : {-100.0f, 100.0f}) ground.positions.emplace_back(x, rise_x * x + rise_z * z, z);
  ground.triangles = {{0, 1, 3}, {0, 3, 2}};
  scene.meshes = {ground};
  scene.instances.resize(1);
  return scene;
}

}  // namespace

TEST_CASE("on a slope the car takes the slope's height, pitch and roll for any heading") {
  const SceneRays rays(slope(0.1f, -0.05f));  // climbs to the east and to the north
  const auto standing = [&](double heading_rad) {
    return on_wheels(rays, {.position = {20, 2.2, 0}, .heading_rad = heading_rad});
  };
  const Vector3d normal = Vector3d(-0.1, 1, 0.05).normalized();
  for (const double heading : {0.0, 0.7, 1.5708, 3.0, -2.0}) {
    INFO(heading);
    const Place place = standing(heading);
    CHECK(place.position.y() == Approx(2.0).margin(1e-4));
    // Pitch and roll are taken from slopes, so the error is of second order in them.
    CHECK((world_from_vehicle(place).linear().col(2) - normal).norm() < 1e-3);
    CHECK(place.heading_rad == heading);
  }
  CHECK(standing(0).pitch_rad == Approx(std::atan(0.1)).margin(1e-5));
  CHECK(standing(0).roll_rad == Approx(-std::atan(-0.05)).margin(1e-5));  // the left, in the north, is higher
}

TEST_CASE("a place stays unchanged if a wheel finds no ground") {
  const SceneRays rays(slope(0, 0));
  for (const Vector3d& position : {Vector3d(99, 0, 0), Vector3d(0, 0.9, 0), Vector3d(0, -0.9, 0)}) {
    const Place place = on_wheels(rays, {.position = position, .pitch_rad = 0.05});
    CHECK(place.position == position);
    CHECK(place.pitch_rad == 0.05);
  }
  CHECK(on_wheels(rays, {.position = {0, 0.5, 0}}).position.y() == Approx(0).margin(1e-6));
  CHECK_FALSE(first_hit(rays, {0, 1, 0}, {0, 1, 0}).has_value());
}
