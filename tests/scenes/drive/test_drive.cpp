#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>

#include "scenes/drive/drive_search.h"
#include "scenes/drive/file_frame.h"
#include "scenes/drive/route_file.h"
#include "scenes/drive/street_piece.h"
#include "scenes/places/clearance.h"
#include "scenes/routes.h"
#include "tests/scenes/box.h"
#include "tests/temporary_folder.h"

using namespace cps;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

/// A road along x, 10 m wide and 200 m long, between two rows of houses. The ground continues below the
/// houses.
Scene street() {
  Scene scene;
  scene.materials.resize(1);
  scene.meshes = {box()};
  add_box(scene, {-100, -1, -25}, {100, 0, 25});
  for (int i = 0; i < 10; ++i)
    for (const float z : {-15.0f, 5.0f}) {
      const float x = -100 + 20.0f * static_cast<float>(i);
      add_box(scene, {x, 0, z}, {x + 20, 12, z + 10});
    }
  return scene;
}

std::vector<Lane> route_of(const std::string& text, double scale = 1) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "drive.csv") << text;
  return read_route(folder.path / "drive.csv", {.metres_per_unit = scale});
}

}  // namespace

TEST_CASE("the drivable ground is the road between houses, not the ground below them") {
  const Scene scene = street();
  const SceneRays rays(scene);
  const GroundGrid ground = ground_grid(scene, rays);
  CHECK(ground.room_at({0, 0}) == Approx(5).margin(1.0));
  CHECK(ground.room_at({0, 4.6}) < 1);
  CHECK(ground.room_at({0, 10}) == 0);  // in a house
  CHECK(ground.room_at({150, 0}) == 0);
  CHECK(ground.ground_at({3, 1}).y() == Approx(0).margin(1e-5));
  CHECK(ground.area_m2 == Approx(200 * 10).epsilon(0.15));
}

TEST_CASE("a car can drive below a high bridge, but not below a low one") {
  for (const float height : {1.5f, 4.0f}) {
    Scene scene = street();
    add_box(scene, {-5, height, -3}, {5, height + 0.3f, 3});
    const SceneRays rays(scene);
    INFO(height);
    CHECK((ground_grid(scene, rays).room_at({0, 0}) > 1) == (height > 2.2f));
  }
}

// In the model LittlestTokyo, an outline hull 8 cm outside everything made the space above the ground too
// low.
TEST_CASE("an outline hull (a shell turned inside out) is no ceiling, and a place in it is not inside") {
  Scene scene = street();
  scene.meshes.push_back(box());
  for (Eigen::Vector3i& triangle : scene.meshes[1].triangles) std::swap(triangle.y(), triangle.z());
  add_box(scene, {-100.5f, -1.08f, -25.5f}, {100.5f, 0.08f, 25.5f});
  scene.instances.back().mesh = 1;
  const SceneRays rays(scene);
  CHECK(ground_grid(scene, rays).room_at({0, 0}) == Approx(5).margin(1.0));
  CHECK(clearance_fault(rays, {0, 1.5, 0}, {1, 0, 0}, 2.5) == PlaceFault::none);
}

TEST_CASE("drives keep their distance from walls and from each other") {
  const Scene scene = street();
  const SceneRays rays(scene);
  const std::vector<Lane> drives = find_drives(ground_grid(scene, rays));
  REQUIRE(!drives.empty());
  double longest_m = 0;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    longest_m = std::max(longest_m, length_m(drives[i]));
    for (const Vector3f& point : drives[i].points) {
      CHECK(std::abs(point.z()) < 5 - 1.0);
      CHECK(std::abs(point.x()) < 100);
      for (std::size_t j = 0; j < i; ++j)
        for (const Vector3f& other : drives[j].points) CHECK((point - other).norm() > 2.4);
    }
  }
  CHECK(longest_m > 80);
}

TEST_CASE(
    "a car drives where things stand on both sides: not on the lawn around, the sea below or on roofs") {
  Scene scene = street();
  add_box(scene, {-400, -1.5f, -400}, {400, -0.05f, 400});  // a lawn, a kerb below the road
  add_box(scene, {-900, -9, -900}, {900, -8, 900});         // water
  const SceneRays rays(scene);
  const std::vector<Lane> drives = find_drives(ground_grid(scene, rays));
  REQUIRE(!drives.empty());
  double on_road_m = 0, whole_m = 0;
  for (const Lane& drive : drives)
    for (const Vector3f& point : drive.points) {
      CHECK(point.y() > -0.2f);
      CHECK(point.y() < 0.2f);
      whole_m += 1;
      on_road_m += std::abs(point.z()) < 5 && std::abs(point.x()) < 105 ? 1 : 0;
    }
  CHECK(on_road_m > 0.9 * whole_m);
}

TEST_CASE("houses without ground have no drives, though their roofs are flat") {
  Scene scene = street();
  scene.instances.erase(scene.instances.begin());  // the ground
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    scene.instances[i].world_from_mesh.prescale(Vector3f(1, i % 3 == 0 ? 1.5f : 1.0f, 1));
  scene.bounds.extend(Vector3f(0, 18, 0));
  const SceneRays rays(scene);
  CHECK(street_piece(ground_layers(scene, rays), rays).piece == -1);
  CHECK(find_drives(ground_grid(scene, rays)).empty());
}

TEST_CASE("things on both sides are counted by heading") {
  // Things along +z only: to the right of somebody who looks along +x.
  Surroundings right;
  for (int i : {3, 4, 5}) right.seen |= static_cast<std::uint16_t>(1 << i);
  CHECK(right.share() == 3 / 16.0);
  CHECK(right.on_both_sides(0) == 0);
  Surroundings both = right;
  for (int i : {11, 12, 13}) both.seen |= static_cast<std::uint16_t>(1 << i);
  CHECK(both.on_both_sides(0) > 0.4);
  CHECK(both.on_both_sides(std::numbers::pi) > 0.4);
  CHECK(both.on_both_sides(std::numbers::pi / 2) == 0);  // ahead and behind
  // A heading of 45° points at direction 14; beside it are 2 and 10.
  const Surroundings slanted{1 << 2 | 1 << 10};
  CHECK(slanted.on_both_sides(std::numbers::pi / 4) > 0);
  CHECK(slanted.on_both_sides(-std::numbers::pi / 4) == 0);
  CHECK(right.ahead(0) == 0);
  CHECK(right.ahead(-std::numbers::pi / 2) > 0.5);  // along +z
}

TEST_CASE("a scene without drivable ground has no drives") {
  Scene scene;
  scene.materials.resize(1);
  scene.meshes = {box()};
  add_box(scene, {0, 0, 0}, {2, 10, 2});
  CHECK(find_drives(ground_grid(scene, SceneRays(scene))).empty());
}

TEST_CASE("the unit of a scene is the metre unless no place looks like that") {
  const auto in_units = [](Scene scene, double metres) {
    scale_scene(scene, 1 / metres);
    return scene;
  };
  // 200 x 13 x 50 m; a flat network of roads.
  CHECK(guess_unit_scale(street()) == 1);
  CHECK(guess_unit_scale(in_units(street(), 0.0254)) == 1);  // inches: --metres_per_unit says so
  Scene roads;
  roads.materials.resize(1);
  roads.meshes = {box()};
  add_box(roads, {0, -0.2f, 0}, {30'000, 0, 30'000});
  CHECK(guess_unit_scale(roads) == 1);
  Scene block;  // 60 x 13 x 50 m
  block.materials.resize(1);
  block.meshes = {box()};
  add_box(block, {-30, -1, -25}, {30, 0, 25});
  for (int i = 0; i < 3; ++i) add_box(block, {20.0f * i - 30, 0, 5}, {20.0f * i - 10, 12, 15});
  for (const double unit : {0.01, 0.1, 1.0, 1000.0})
    CHECK(guess_unit_scale(in_units(block, unit)) == Approx(unit));
}

TEST_CASE("a scene whose z points up cannot be driven, and turned it is as it should be") {
  const Scene scene = street();
  Scene z_up = scene;
  Eigen::Matrix3f there;
  there << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // (x, y, z) to (x, −z, y)
  for (Instance& instance : z_up.instances) instance.world_from_mesh.prerotate(there);
  z_up.bounds.setEmpty();
  z_up.bounds.extend(there * scene.bounds.min()).extend(there * scene.bounds.max());
  z_up.lanes = {{.street = "A", .points = {there * Vector3f(1, 2, 3), there * Vector3f(4, 5, 6)}}};
  CHECK(find_drives(ground_grid(z_up, SceneRays(z_up))).empty());
  turn_z_up(z_up);
  CHECK(z_up.bounds.isApprox(scene.bounds));
  CHECK(z_up.lanes[0].points[1] == Vector3f(4, 5, 6));
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    CHECK(z_up.instances[i].world_from_mesh.isApprox(scene.instances[i].world_from_mesh, 1e-5f));
}

TEST_CASE("scaling there and back changes nothing") {
  const Scene scene = street();
  Scene other = scene;
  scale_scene(other, 0.01);
  scale_scene(other, 100);
  CHECK(other.bounds.sizes().isApprox(scene.bounds.sizes(), 1e-5f));
  CHECK(other.instances[3].world_from_mesh.isApprox(scene.instances[3].world_from_mesh, 1e-5f));
}

TEST_CASE("a mast does not change the guessed unit") {
  Scene scene = street();
  add_box(scene, {0, 0, 0}, {1, 350, 1});
  CHECK(guess_unit_scale(scene) == 1);
}

TEST_CASE("scaling a scene scales its lights so that surfaces are as bright as before") {
  Scene scene = street();
  scene.lights = {{.name = "lamp", .position = {1, 2, 3}, .intensity = {1, 1, 1}},
                  {.name = "sun", .kind = PunctualLight::Kind::directional, .intensity = {1, 1, 1}}};
  scale_scene(scene, 10);
  CHECK(scene.lights[0].position == Vector3f(10, 20, 30));
  CHECK(scene.lights[0].intensity == Vector3f(100, 100, 100));
  CHECK(scene.lights[1].intensity == Vector3f(1, 1, 1));
}

TEST_CASE("a route of a file whose z points up is turned as the scene is, less its origin") {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "drive.csv") << "1,2,3\n10,2,3\n";
  const std::vector<Lane> lanes =
      read_route(folder.path / "drive.csv", {.metres_per_unit = 2, .is_z_up = true, .origin = {1, 1, 1}});
  CHECK(lanes.front().points.front() == Vector3f(1, 5, -5));
  CHECK(lanes.back().points.back() == Vector3f(19, 5, -5));
}

TEST_CASE("a route without headings becomes a lane through its points, cut into stretches") {
  const std::vector<Lane> lanes = route_of("x,y,z\n0,1,0\n 100, 1 ,0\n100,1,0\r\n\n100,1,200\n", 2);
  CHECK(lanes.size() == 10);  // 600 m
  std::set<std::string> streets;
  double whole_m = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    streets.insert(lanes[i].street);
    whole_m += length_m(lanes[i]);
    CHECK(length_m(lanes[i]) == Approx(60));
    if (i + 1 == lanes.size()) continue;
    CHECK(lanes[i].next == std::vector<int>{static_cast<int>(i) + 1});
    CHECK(lanes[i].points.back() == lanes[i + 1].points.front());
  }
  CHECK(streets.size() == 10);
  CHECK(whole_m == Approx(600));
  CHECK(lanes.back().points.back() == Vector3f(200, 2, 400));
  CHECK(route_of("0,0,0\n5,0,0\n").size() == 3);
}

TEST_CASE("a route with headings becomes one place per point, with its heading") {
  const std::vector<Lane> lanes = route_of("0,0,0,90\n3,0,0,180\n3,0,0,0\n9,1,2,-45\n");
  REQUIRE(lanes.size() == 4);
  const double expected_deg[] = {90, 180, 0, -45};
  for (int i = 0; i < 4; ++i) {
    const Place place = place_on_lane(lanes[i], 0.05, 0, 0);
    CHECK(std::cos(place.heading_rad - expected_deg[i] * 3.14159265 / 180) == Approx(1).margin(1e-6));
  }
  CHECK(place_on_lane(lanes[3], 0.05, 0, 0).position.isApprox(Vector3d(9, 1, 2), 1e-6));
}

TEST_CASE("an invalid route is refused by file and line") {
  CHECK_THROWS_WITH(route_of("x,y,z\n1,2\n"), Catch::Contains("drive.csv: line 2: must be x,y,z"));
  CHECK_THROWS_WITH(route_of("1,2,3\n1,2,nan\n"), Catch::Contains("line 2"));
  CHECK_THROWS_WITH(route_of("1,2,3\n1,2,3,4\n"), Catch::Contains("line 2"));
  CHECK_THROWS_WITH(route_of("1,2,3\n4,5,1e9\n"), Catch::Contains("10,000 km"));
  CHECK_THROWS_WITH(route_of("1,2,3\n1,2,3\n"), Catch::Contains("too few points"));
  CHECK_THROWS_WITH(route_of(""), Catch::Contains("too few points"));
  CHECK_THROWS_WITH(read_route("/no/such.csv", {}),
                    "/no/such.csv: cannot be read; name a route file, lines of x,y,z");
}
