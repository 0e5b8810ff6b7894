#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "renderer/cache/cell_light.h"
#include "renderer/paths/path_steps.h"
#include "tests/renderer/estimates.h"

using namespace cps;
using namespace cps::handmade;

namespace {

constexpr int cell_vertices = 5;

/// A cube of 1 m around the origin, for the surfaces of material 0 in it that face up.
Cell ground_cell() {
  return cell_at({0, 0, 0}, 3, facing_of(Vec3::UnitY()), true, 0);
}

/// The same cell i cubes further along z.
Cell along_z(Cell cell, int i) {
  cell.index.z() += i;
  return cell;
}

Material two_sided(Material m) {
  m.double_sided = true;
  return m;
}

/// From one point of the xy plane to another, 800 m long along z. Its front is on the left.
Mesh strip(const Eigen::Vector2f& from, const Eigen::Vector2f& to, int material) {
  const Eigen::Vector2f across = to - from;
  return quad({from.x(), from.y(), 400}, {across.x(), across.y(), 0}, {0, 0, -800}, material);
}

Mesh wide_ground() {
  return strip({-400.0f, 0.0f}, {400.0f, 0.0f}, 0);
}

/// Black ground, and things of material 0 or of `other`, material 1.
RenderScene ground_with(const Material& other, const std::vector<Mesh>& things, const SkyAndSun& light) {
  Scene scene;
  scene.materials = {two_sided(lambert({0, 0, 0, 1})), other};
  add(scene, wide_ground());
  for (const Mesh& thing : things) add(scene, thing);
  return RenderScene(scene, light);
}

CellLight light_in(const RenderScene& lit, const Cell& cell, std::uint32_t& rays) {
  return compute_cell_light(
      lit, cell, [&](Path& path, const Hit& hit) { return shade_vertex(lit, cell_vertices, path, hit); },
      rays);
}

CellLight light_in(const RenderScene& lit, const Cell& cell) {
  std::uint32_t rays = 0;
  return light_in(lit, cell, rays);
}

/// Light of 32 cells in a row along z, where nothing changes.
Estimate mean_light(const RenderScene& lit, const Cell& first) {
  return estimate(32, [&](int i) {
    const CellLight light = light_in(lit, along_z(first, i));
    REQUIRE(light.is_known);
    return light.radiance;
  });
}

/// Checks that light is this radiance, which is exact to 1.5 %.
void check_light(const Estimate& seen, double radiance) {
  CAPTURE(seen.mean.transpose(), radiance);
  CHECK(standard_errors_off(seen, Eigen::Array3d::Constant(radiance), 0.015) < max_standard_errors);
}

}  // namespace

TEST_CASE("a cell's points lie on surfaces of its material and facing and in its cube") {
  // The edge of a black table or ramp at height h stands over the middle of the cell. Ground at distance x
  // from below the edge sees the share (1 ± x / √(x² + h²)) / 2 of the sky: in the mean half of it. The tops
  // of table and ramp are the first surfaces in the cube from above, and see more.
  const float middle = cell_corner(ground_cell()).x() + 0.5f, h = 0.5f;
  const Material black = two_sided(lambert({0, 0, 0, 1}));
  const Eigen::Vector2f edge(middle, h), foot(middle - h, 0.0f), far_away(-400.0f, h);
  const RenderScene table_of_another_material =
      ground_with(black, {strip(far_away, edge, 1)}, constant_light(1));
  check_light(mean_light(table_of_another_material, ground_cell()), 0.5);
  const RenderScene ramp_of_the_same = ground_with(black, {strip(foot, edge, 0)}, constant_light(1));
  check_light(mean_light(ramp_of_the_same, ground_cell()), 0.5);

  // A cell around the table's edge, whose cube ends above the ground, has the light of the table alone.
  const Cell around_edge = cell_at({middle, h, 0}, 2, facing_of(Vec3::UnitY()), true, 0);
  REQUIRE(cell_corner(around_edge).y() > 0.1f);
  const RenderScene table_of_the_same = ground_with(black, {strip(far_away, edge, 0)}, constant_light(1));
  CHECK(mean_light(table_of_the_same, around_edge).mean.x() == Approx(1).epsilon(1e-5));
}

TEST_CASE("a cell's light is the same to the last bit with the car in it and without") {
  // A sheet of the ground's material rides with the car, in the cube above the ground: rays that met it would
  // find points on it, or never reach the sky, neither as paths nor as light samples.
  const float middle = cell_corner(ground_cell()).x() + 0.5f;
  Scene scene;
  scene.materials = {two_sided(lambert({0.5f, 0.5f, 0.5f, 1}))};
  add(scene, wide_ground());
  add(scene, strip({middle - 0.5f, 0.0f}, {middle, 0.5f}, 0));
  Scene with_car = scene;
  add(with_car, strip({-400.0f, 0.6f}, {400.0f, 0.6f}, 0));
  with_car.instances.back().rides = true;
  for (const SkyAndSun& light : {constant_light(1), make_sky_and_sun({.sky = SkyModel::overcast})}) {
    const RenderScene without(scene, light), with(with_car, light);
    for (int i = 0; i < 8; ++i) {
      std::uint32_t rays_without = 0, rays_with = 0;
      const CellLight expected = light_in(without, along_z(ground_cell(), i), rays_without);
      const CellLight seen = light_in(with, along_z(ground_cell(), i), rays_with);
      REQUIRE(expected.is_known);
      REQUIRE(expected.radiance.minCoeff() > 0);
      CHECK((seen.radiance == expected.radiance).all());
      CHECK((seen.towards == expected.towards));
      CHECK(seen.is_near == expected.is_near);
      CHECK(rays_with == rays_without);
    }
  }
}

TEST_CASE("a cell leaves out the lamps that its surfaces sample themselves but not their reflections") {
  // A closed sphere emits 1 and reflects ρ, and its triangles are all of its lamps. Of n shaded vertices the
  // cell's own is the first: its paths bring ρ + ρ² + … + ρ^(n−1). Light samples and paths that meet the
  // sphere by chance bring about half of each term.
  constexpr float radius = 2, albedo = 0.5f;
  Material glowing = two_sided(lambert({albedo, albedo, albedo, 1}));
  glowing.emissive = Vec3::Ones();
  const RenderScene lit(scene_of(glowing, sphere(radius, 0, 48)), no_light());
  const Estimate seen = estimate(32, [&](int i) {
    Vec3 at = cell_corner({{i % 6 - 3, 0, i / 6 - 3}, 0, 0, true, 0}) + Vec3::Constant(cell_size_m(0) / 2);
    at.y() = 0;
    at.y() = -std::sqrt(radius * radius - at.squaredNorm());
    const CellLight light = light_in(lit, cell_at(at, 0, facing_of(Vec3::UnitY()), true, 0));
    REQUIRE(light.is_known);
    return light.radiance;
  });
  double expected = 0;
  for (int n = 1; n < cell_vertices; ++n) expected += std::pow(albedo, n);
  check_light(seen, expected);
}

TEST_CASE("a cell leaves out the sun but not what other surfaces reflect of it") {
  // A sun as wide as the whole sky, of radiance 1, above the foot of a wall without end: the wall gets half
  // of its light, and hides half of the sky from the ground. Wide, so that light samples and paths that meet
  // the sun by chance both count.
  constexpr float pi = std::numbers::pi_v<float>, albedo = 0.8f;
  const float foot = cell_corner(ground_cell()).x();
  const RenderScene lit =
      ground_with(two_sided(lambert({albedo, albedo, albedo, 1})), {strip({foot, 0.0f}, {foot, 400.0f}, 1)},
                  sun_only(Vec3::UnitY(), Color::Constant(4 * pi), 2 * pi));
  check_light(mean_light(lit, ground_cell()), albedo / 4);
}

TEST_CASE("a cell draws more points where the light of the first ones differs") {
  // At the foot of a wall without end half of the paths meet it. If it shines with v and the sky with 1, the
  // paths' standard deviation is the share (1 − v) / (1 + v) of their mean. Of 64 paths the mean
  // is off by 2.2 % for v = 0.7, which is good enough, and by 5.4 % for v = 0.4. The border is 4 %.
  const float foot = cell_corner(ground_cell()).x();
  const auto rays_beside = [&](float v) {
    Material shining = two_sided(lambert({v, v, v, 1}));
    shining.unlit = true;
    const RenderScene lit = ground_with(shining, {strip({foot, 0.0f}, {foot, 400.0f}, 1)}, constant_light(1));
    std::uint32_t rays = 0;
    light_in(lit, ground_cell(), rays);
    return rays;
  };
  // One ray finds a point, and one is its path.
  CHECK(rays_beside(1.0f) == 2 * 64);
  CHECK(rays_beside(0.7f) == 2 * 64);
  CHECK(rays_beside(0.4f) == 2 * 256);
}

TEST_CASE("a cell is near other surfaces if more than one path in twenty meets them within two cells") {
  // From ground at distance x, directions whose level component towards a wall without end exceeds x / r meet
  // it within r. Weighted by the cosine, these are a segment of a disc (Nusselt's analogue): within two cells
  // 13.5 % of the paths of a cell that begins 0.75 m from the wall, and 1.5 % where it begins 1.5 m away.
  const auto beside_wall = [&](float distance_m, int i) {
    const float wall = cell_corner(ground_cell()).x() - distance_m;
    const RenderScene lit = ground_with(two_sided(lambert({0, 0, 0, 1})),
                                        {strip({wall, 0.0f}, {wall, 400.0f}, 1)}, constant_light(1));
    const CellLight light = light_in(lit, along_z(ground_cell(), i));
    REQUIRE(light.is_known);
    return light;
  };
  for (int i = 0; i < 4; ++i) {
    CHECK(beside_wall(0.75f, i).is_near);
    CHECK_FALSE(beside_wall(1.5f, i).is_near);
  }
}

TEST_CASE("ground inside a solid is left out of the light of the ground beside it") {
  // A flat solid, whose faces look outwards alone, covers half of the cell. Beside it the ground sees the
  // share (1 + x / √(x² + h²)) / 2 of the sky; the ground in it is dark.
  const float middle = cell_corner(ground_cell()).x() + 0.5f, h = 0.1f, half = 0.5f;
  const RenderScene lit = ground_with(
      lambert({0, 0, 0, 1}), {strip({-400.0f, h}, {middle, h}, 1), strip({middle, h}, {middle, 0.0f}, 1)},
      constant_light(1));
  check_light(mean_light(lit, ground_cell()), 0.5 + (std::hypot(half, h) - h) / (2 * half));
}

TEST_CASE("a cell of which hardly any surface is found has no light") {
  const auto with_patch = [](float side_m) {
    const Vec3 low = cell_corner(ground_cell());
    const Mesh patch = quad({low.x() + 0.2f, 0, low.z() + 0.2f + side_m}, {side_m, 0, 0}, {0, 0, -side_m});
    return light_in(RenderScene(scene_of(lambert({0, 0, 0, 1}), patch), constant_light(1)), ground_cell());
  };
  CHECK_FALSE(with_patch(0.25f).is_known);  // about 4 of 64 lines meet it
  REQUIRE(with_patch(0.5f).is_known);       // about 16
  CHECK(with_patch(0.5f).radiance.x() == Approx(1).epsilon(1e-5));
}
