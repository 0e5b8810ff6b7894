#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "scenes/enclosures.h"
#include "tests/scenes/box.h"

using namespace cps;

namespace {

/// A part of a sphere of radius 1: longitudes from..to, in turns, latitudes from the equator or the south
/// pole up; its faces look outwards.
Mesh sphere_part(double from, double to, bool only_upper) {
  constexpr int columns = 24, rows = 24;
  Mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double low = only_upper ? 0 : -0.5, latitude = std::numbers::pi * (low + (0.5 - low) * j / rows),
                   longitude = 2 * std::numbers::pi * (from + (to - from) * i / columns);
      mesh.positions.emplace_back(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                                  -std::cos(latitude) * std::sin(longitude));
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + columns + 1;
      mesh.triangles.emplace_back(a, a + 1, b);
      mesh.triangles.emplace_back(a + 1, b + 1, b);
    }
  return mesh;
}

Mesh turned_round(Mesh mesh) {
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t.y(), t.z());
  return mesh;
}

/// A quad between two corners, with corners a, b, and a third.
Mesh quad(const Eigen::Vector3f& corner, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  Mesh mesh;
  mesh.positions = {corner, corner + a, corner + a + b, corner + b};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

void place(Scene& scene, const Mesh& mesh, double size, const Eigen::Vector3f& at = {0, 0, 0}) {
  scene.meshes.push_back(mesh);
  Instance instance{static_cast<int>(scene.meshes.size()) - 1};
  instance.world_from_mesh = Eigen::Translation3f(at) * Eigen::Scaling(static_cast<float>(size));
  scene.instances.push_back(instance);
}

/// A street of 40 houses, 12 m high, on ground.
Scene street() {
  Scene scene;
  scene.materials.resize(1);
  place(scene, quad({-300, 0, 300}, {600, 0, 0}, {0, 0, -600}), 1);
  for (int i = 0; i < 40; ++i)
    place(scene, box(), 6, {static_cast<float>(15 * (i / 2) - 150), 6, i % 2 == 0 ? 12.0f : -12.0f});
  return scene;
}

std::vector<int> marked(Scene scene) {
  mark_enclosures(scene);
  std::vector<int> meshes;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (scene.meshes[i].is_enclosure) meshes.push_back(static_cast<int>(i));
  return meshes;
}

}  // namespace

TEST_CASE("a sky dome is an enclosure, whole or in parts, whichever way its faces look") {
  const int first = static_cast<int>(street().meshes.size());
  for (bool only_upper : {true, false})
    for (double radius : {400.0, 5000.0}) {
      CAPTURE(only_upper, radius);
      for (bool inwards : {false, true}) {
        Scene scene = street();
        const Mesh whole = sphere_part(0, 1, only_upper);
        place(scene, inwards ? turned_round(whole) : whole, radius, {0, -1, 0});
        CHECK(marked(scene) == std::vector<int>{first});
      }
      Scene halves = street();
      place(halves, sphere_part(0, 0.5, only_upper), radius, {0, -1, 0});
      place(halves, sphere_part(0.5, 1, only_upper), radius, {0, -1, 0});
      CHECK(marked(halves) == std::vector<int>{first, first + 1});
    }
}

TEST_CASE("houses below the rim of a dome do not belong to it") {
  Scene scene = street();
  const int first = static_cast<int>(scene.meshes.size());
  place(scene, sphere_part(0, 1, true), 400, {0, 85, 0});
  CHECK(marked(scene) == std::vector<int>{first});
}

TEST_CASE("a sky box of six pictures is an enclosure, but for its floor") {
  Scene scene = street();
  const int first = static_cast<int>(scene.meshes.size());
  const Eigen::Vector3f x(2, 0, 0), y(0, 2, 0), z(0, 0, 2), low(-1, -1, -1);
  for (const Mesh& side : {quad(low + y, x, z), quad(low, x, y), quad(low + z, x, y), quad(low, y, z),
                           quad(low + x, y, z), quad(low, x, z)})
    place(scene, side, 500);
  CHECK(marked(scene) == std::vector<int>{first, first + 1, first + 2, first + 3, first + 4});
}

TEST_CASE("streets, roofs over a part, and valleys are no enclosures") {
  CHECK(marked(street()).empty());
  Scene roofed = street();
  place(roofed, quad({-60, 20, 60}, {120, 0, 0}, {0, 0, -120}), 1);
  CHECK(marked(roofed).empty());
  Scene valley = street();  // a bowl of mountains, open above
  Mesh bowl = sphere_part(0, 1, true);
  std::erase_if(bowl.triangles, [&](const Eigen::Vector3i& t) { return bowl.positions[t[0]].y() > 0.5f; });
  place(valley, bowl, 2000);
  CHECK(marked(valley).empty());
}
