#include <catch2/catch.hpp>
#include <set>

#include "renderer/cache/cell.h"
#include "renderer/cache/cell_sizes.h"

using namespace cps;

TEST_CASE("a cell contains the points that lie in it, on every level") {
  const Stream stream = make_stream(1, "points");
  for (int i = 0; i < 3000; ++i) {
    const auto coordinate = [&](int axis) {
      return static_cast<float>(random_uniform(stream, 3 * i + axis, -900, 900));
    };
    const Vec3 position(coordinate(0), coordinate(1), coordinate(2));
    const int level = i % 8;
    const Cell cell = cell_at(position, level, 4, false, 0);
    const Vec3 inside = (position - cell_corner(cell)) / cell_size_m(level);
    const float rounding = 1e-3f / cell_size_m(level);
    CHECK(inside.minCoeff() >= -rounding);
    CHECK(inside.maxCoeff() <= 1 + rounding);
  }
}

TEST_CASE("a surface's facing is the nearest of 26 directions, but for those about between two") {
  const Stream stream = make_stream(2, "directions");
  std::set<std::uint32_t> facings;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 normal = Vec3(static_cast<float>(random_normal(stream, 3 * i)),
                             static_cast<float>(random_normal(stream, 3 * i + 1)),
                             static_cast<float>(random_normal(stream, 3 * i + 2)))
                            .normalized();
    const std::uint32_t facing = facing_of(normal);
    facings.insert(facing);
    CHECK(facing_direction(facing).dot(normal) > 0.8f);  // 37°
    CHECK(facing_of(facing_direction(facing)) == facing);
  }
  CHECK(facings.size() == 26);
}

TEST_CASE("cells that differ in anything have different hashes") {
  std::set<std::uint64_t> hashes;
  std::size_t cells = 0;
  for (int x = -9; x < 9; ++x)
    for (int y = -9; y < 9; ++y)
      for (int z = -9; z < 9; ++z)
        for (std::uint8_t level = 0; level < 4; ++level)
          for (std::uint8_t facing : {1, 4, 26})
            for (std::uint32_t material : {0, 1, 77})
              for (bool is_far : {false, true}) {
                hashes.insert(Cell{{x, y, z}, level, facing, is_far, material}.hash());
                ++cells;
              }
  CHECK(hashes.size() == cells);
}

TEST_CASE("cells are half a metre near lanes and grow with the distance from them") {
  Scene scene;
  Lane lane{.street = "a", .points = {{-100, 2, 0}, {100, 2, 0}}};
  scene.lanes = {lane};
  scene.bounds.extend(Eigen::Vector3f(-200, 0, -200)).extend(Eigen::Vector3f(200, 50, 200));
  const CellSizes sizes = make_cell_sizes(scene);
  CHECK(sizes.level_at({0, 2, 0}) == 2);
  CHECK(cell_size_m(2) == 0.5f);
  CHECK(sizes.level_at({50, 2, 15}) == 2);
  CHECK(sizes.level_at({0, 2, 64}) == Approx(4).margin(0.05));
  CHECK(sizes.level_at({0, 34, 0}) == Approx(3).margin(0.05));  // above the lane
  // Beyond the map: as at its rim.
  CHECK(sizes.level_at({0, 2, 1e6f}) == sizes.level_at({0, 2, 1e5f}));
  CHECK(make_cell_sizes(Scene{}).level_at({1, 2, 3}) == 2);
}
