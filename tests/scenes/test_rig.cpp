#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "scenes/rig.h"

using cps::Place;
using cps::RigCamera;
using cps::vehicle_from_camera;
using cps::world_from_vehicle;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

bool close(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm() < 1e-12;
}

RigCamera turned(double yaw_deg, double pitch_deg, double roll_deg) {
  return {.name = "c",
          .position_m = Vector3d::Zero(),
          .yaw_deg = yaw_deg,
          .pitch_deg = pitch_deg,
          .roll_deg = roll_deg};
}

}  // namespace

TEST_CASE("a camera without angles on a car heading along +x looks along +x with +y up") {
  const Isometry3d world_from_camera =
      world_from_vehicle({.position = {10, 2, 5}}) * vehicle_from_camera({.position_m = {1.68, 0.3, 1.65}});
  CHECK(close(world_from_camera.linear().col(2), Vector3d::UnitX()));   // forward
  CHECK(close(world_from_camera.linear().col(1), -Vector3d::UnitY()));  // down
  CHECK(close(world_from_camera.linear().col(0), Vector3d::UnitZ()));   // right: south, world +z
  CHECK(close(world_from_camera.translation(), {11.68, 3.65, 4.7}));    // left is −z
}

TEST_CASE("the axes of KITTI's velodyne-to-camera calibration") {
  // R of calib_velo_to_cam.txt is this permutation to within a degree: camera x = −y, y = −z, z = x of the
  // car.
  const Eigen::Matrix3d camera_from_vehicle = vehicle_from_camera(turned(0, 0, 0)).linear().transpose();
  Eigen::Matrix3d expected;
  expected << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  CHECK(camera_from_vehicle == expected);
}

TEST_CASE("yaw turns left, pitch up, roll clockwise, in this order") {
  const double half = std::sqrt(0.5);
  CHECK(close(vehicle_from_camera(turned(90, 0, 0)).linear().col(2), {0, 1, 0}));
  CHECK(close(vehicle_from_camera(turned(0, 45, 0)).linear().col(2), {half, 0, half}));
  // Clockwise for the driver: the camera's right edge goes down.
  CHECK(close(vehicle_from_camera(turned(0, 0, 90)).linear().col(0), {0, 0, -1}));
  // First turned left, then up: the optical axis points to the left and up.
  CHECK(close(vehicle_from_camera(turned(90, 45, 0)).linear().col(2), {0, half, half}));
  const Eigen::Matrix3d m = vehicle_from_camera(turned(31, -17, 8)).linear();
  CHECK((m * m.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  CHECK(m.determinant() == Approx(1));
}

TEST_CASE("a positive heading turns left") {
  const Isometry3d north = world_from_vehicle({.heading_rad = std::numbers::pi / 2});
  CHECK(close(north.linear().col(0), {0, 0, -1}));  // forward
  CHECK(close(north.linear().col(1), {-1, 0, 0}));  // left of north is west
  CHECK(close(north.linear().col(2), {0, 1, 0}));
}

TEST_CASE("positive pitch raises the nose, positive roll lowers the right side") {
  const double up = 0.1, half_turn = std::numbers::pi / 2;
  const Isometry3d climbing = world_from_vehicle({.heading_rad = half_turn, .pitch_rad = up});
  CHECK(close(climbing.linear().col(0), {0, std::sin(up), -std::cos(up)}));
  CHECK(close(climbing.linear().col(1), {-1, 0, 0}));
  const Isometry3d leaning = world_from_vehicle({.roll_rad = up});
  CHECK(close(leaning.linear().col(0), Vector3d::UnitX()));
  CHECK(close(-leaning.linear().col(1), {0, -std::sin(up), std::cos(up)}));  // right is world +z, and down
}

TEST_CASE("a rig without cameras or with a repeated camera name is refused") {
  CHECK(cps::Rig{}.fault() == "");
  CHECK(cps::Rig{.cameras = {}}.fault() == "has no camera");
  CHECK(cps::Rig{.cameras = {{.name = "a"}, {.name = "b"}, {.name = "a"}}}.fault() ==
        "a: is the name of two cameras");
  CHECK(cps::Rig{.cameras = {{.name = "a", .pitch_deg = 91}}}.fault() ==
        "a: pitch_deg must be within -90 and 90");
}

TEST_CASE("an invalid rig camera is refused by the field's name") {
  CHECK(RigCamera{}.fault() == "");
  CHECK(RigCamera{.name = "../x"}.fault() == "name = \"../x\" must be 1 to 64 letters, digits, - or _");
  CHECK(RigCamera{.position_m = {0, std::nan(""), 0}}.fault() ==
        "position_m must lie within 50 m of the car's origin");
  CHECK(RigCamera{.pitch_deg = 91}.fault() == "pitch_deg must be within -90 and 90");
}
