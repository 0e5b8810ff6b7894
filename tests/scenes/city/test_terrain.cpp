#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "scenes/city/buildings/foundation.h"
#include "scenes/city/geometry/refine.h"
#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/road_surface.h"
#include "scenes/city/streets/terrain.h"

using namespace cps;
using namespace cps::city;

namespace {

/// The steepest terrain possible.
Terrain steep() {
  const double wave_number = 2 * 3.14159265358979 / 350;
  return {{{Vec2(wave_number, 0), 0.06 / wave_number, 0.3}}};
}

Materials numbered_materials() {
  Materials m{};
  m.asphalt = 1;
  m.asphalt_patch = 2;
  m.kerb = 3;
  m.gutter = 4;
  m.paving = 5;
  m.stone = {6, 1};
  m.concrete = {{7, 1}};
  return m;
}

/// The edges that only one triangle has, by their ends rounded to half a millimetre, with the difference of
/// forward and backward uses.
using Point = std::array<long, 3>;
std::map<std::pair<Point, Point>, int> open_edges(const std::vector<const Surface*>& surfaces) {
  std::map<std::pair<Point, Point>, int> count;
  for (const Surface* s : surfaces)
    for (std::size_t t = 0; t < s->indices.size(); t += 3)
      for (int k = 0; k < 3; ++k) {
        const auto key = [&](int corner) {
          const Eigen::Vector3f& p = s->positions[s->indices[t + corner % 3]];
          return Point{std::lround(p.x() * 2000), std::lround(p.y() * 2000), std::lround(p.z() * 2000)};
        };
        const Point a = key(k), b = key(k + 1);
        if (a == b) continue;
        a < b ? ++count[{a, b}] : --count[{b, a}];
      }
  std::erase_if(count, [](const auto& edge) { return edge.second == 0; });
  return count;
}

}  // namespace

TEST_CASE("slopes are the height field's derivatives, below their bound and the style's limit") {
  int level = 0;
  double steepest_seen = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (const CityStyle style : {CityStyle::european, CityStyle::downtown, CityStyle::industrial}) {
      const Terrain terrain = draw_terrain({.seed = seed, .style = style});
      level += terrain.waves.empty();
      CHECK(terrain.steepest() <= slope_limit(style) + 1e-12);
      for (const Terrain::Wave& w : terrain.waves) CHECK(w.per_metre.norm() <= 2 * 3.1415927 / 350);
      for (double x = -500; x <= 500; x += 50)
        for (double y = -500; y <= 500; y += 50) {
          const Vec2 p(x, y), slope = terrain.slope(p);
          const auto difference = [&](const Vec2& step) {
            return (terrain.height_m(p + step) - terrain.height_m(p - step)) / (2 * step.norm());
          };
          if ((slope - Vec2(difference({1, 0}), difference({0, 1}))).norm() > 1e-5) FAIL_CHECK("slope");
          if (slope.norm() > terrain.steepest() + 1e-12) FAIL_CHECK("bound");
          steepest_seen = std::max(steepest_seen, slope.norm());
        }
    }
  CHECK(level > 15);  // a quarter of 120; binomial, 99.9 %: 16 … 46
  CHECK(level < 47);
  CHECK(steepest_seen > 0.04);
}

TEST_CASE("draped ground deviates from the terrain by less than patches lie above the asphalt") {
  const Terrain terrain = steep();
  Surface flat;
  add_floor(flat, {{-60, -40}, {70, -30}, {50, 60}, {-40, 30}}, 0, 1);
  Mesh mesh{"floor", {{0, flat}}};
  drape(mesh, terrain);
  const Surface& s = mesh.surfaces[0];
  double worst = 0;
  for (std::size_t t = 0; t < s.indices.size(); t += 3)
    for (const auto& [u, v] : {std::pair{1 / 3.f, 1 / 3.f}, {0.5f, 0.5f}, {0.5f, 0.f}, {0.f, 0.5f}}) {
      const Eigen::Vector3f p = s.positions[s.indices[t]] * (1 - u - v) + s.positions[s.indices[t + 1]] * u +
                                s.positions[s.indices[t + 2]] * v;
      worst = std::max(worst, std::abs(p.y() - terrain.height_m({p.x(), -p.z()})));
    }
  CHECK(worst < patch_height_m);
  CHECK(worst > 0);
}

TEST_CASE("ground on level terrain is not refined") {
  Surface flat;
  add_floor(flat, {{0, 0}, {50, 0}, {50, 50}, {0, 50}}, 0.12, 1);
  Mesh mesh{"floor", {{0, flat}}};
  drape(mesh, {});
  CHECK(mesh.triangle_count() == 2);
}

TEST_CASE("on a slope, a block's pavements and ground meet without a gap") {
  const Materials materials = numbered_materials();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network =
        draw_street_network({.seed = seed, .style = static_cast<CityStyle>(seed), .extent_m = 300});
    for (const Block& block : network.blocks) {
      if (block.at_rim) continue;
      std::vector<double> pavement_m;
      for (const Side& side : block.sides) pavement_m.push_back(network.profile(side).pavement_m);
      Mesh mesh = pavement(network, block, pavement_m, materials);
      const Outline border =
          outline(network, block, pavement_m, *std::max_element(pavement_m.begin(), pavement_m.end()));
      add_floor(mesh.surfaces[9], border.points, kerb_height_m, 1);
      drape(mesh, steep(), max_block_edge_m);
      // Together, paving, ground and kerb have no open edges inside the block.
      std::vector<const Surface*> surfaces{&mesh.surfaces[materials.paving], &mesh.surfaces[9],
                                           &mesh.surfaces[materials.kerb]};
      int inner = 0;
      for (const auto& [edge, count] : open_edges(surfaces)) {
        const Vec2 middle(static_cast<double>(edge.first[0] + edge.second[0]) / 4000,
                          -static_cast<double>(edge.first[2] + edge.second[2]) / 4000);
        Polygon closed = border.points;
        closed.push_back(closed.front());
        inner += distance_to_line(closed, middle) < 0.5;
      }
      CHECK(inner == 0);
    }
  }
}

TEST_CASE("on a slope, gaps between carriageways and junctions are smaller than the apron's depth") {
  const Materials materials = numbered_materials();
  const StreetNetwork network = draw_street_network({.seed = 3, .extent_m = 300});
  const Terrain terrain = steep();
  const auto above_terrain = [&](const Eigen::Vector3f& p) {
    return p.y() - terrain.height_m({p.x(), -p.z()});
  };
  // Along the common border both surfaces are chords of the terrain, so the gap between them is at most the
  // sum of their deviations at the middles of their edges.
  const auto max_deviation = [&](const Surface& s) {
    double worst = 0;
    for (std::size_t t = 0; t < s.indices.size(); t += 3)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3f &a = s.positions[s.indices[t + k]],
                              &b = s.positions[s.indices[t + (k + 1) % 3]];
        worst = std::max({worst, std::abs(above_terrain(a)), std::abs(above_terrain((a + b) / 2))});
      }
    return worst;
  };
  double street_m = 0, junction_m = 0, apron_m = 1;
  for (std::size_t s = 0; s < network.streets.size(); ++s) {
    Mesh mesh = carriageway(network, static_cast<int>(s), materials, 3);
    drape(mesh, terrain);
    street_m = std::max(street_m, max_deviation(mesh.surfaces[materials.asphalt]));
  }
  for (std::size_t j = 0; j < network.junctions.size(); ++j) {
    Mesh mesh = junction_floor(network, static_cast<int>(j), materials, 3);
    if (mesh.empty()) continue;
    drape(mesh, terrain);
    junction_m = std::max(junction_m, max_deviation(mesh.surfaces[materials.asphalt]));
    double deepest_m = 0;
    for (const Eigen::Vector3f& p : mesh.surfaces[materials.asphalt_patch].positions)
      deepest_m = std::max(deepest_m, -above_terrain(p));
    apron_m = std::min(apron_m, deepest_m);
  }
  CHECK(junction_m > 0);
  CHECK(street_m + junction_m < apron_m);
}

TEST_CASE("lanes follow the terrain's height and slope") {
  const Terrain terrain = steep();
  for (const DrivingLane& lane : driving_lanes(draw_street_network({.seed = 2, .extent_m = 300}))) {
    const std::vector<Vec3> points = on_terrain(lane.points, terrain);
    CHECK((points.front() - lift(lane.points.front(), terrain.height_m(lane.points.front()))).norm() < 1e-9);
    CHECK((points.back() - lift(lane.points.back(), terrain.height_m(lane.points.back()))).norm() < 1e-9);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 step = points[i] - points[i - 1];
      if (std::abs(step.y()) > 0.06 * std::hypot(step.x(), step.z()) + 1e-9) FAIL_CHECK("too steep");
      if (step.norm() > 3.6) FAIL_CHECK("too long");
    }
  }
}

TEST_CASE("on a slope, houses stand at the height of their highest door and reach below the lowest ground") {
  const Materials m = numbered_materials();
  const Terrain terrain = steep();
  BuildingPlan plan;
  plan.footprint = make_footprint({{-12, -5}, {12, -5}}, 10);
  Building house;
  house.doorways = {{{-8, -5}, {0, -1}, 1.2, false}, {{8, -5}, {0, -1}, 1.2, false}};
  const double level_m = ground_level_m(house, plan, terrain);
  CHECK(level_m == Approx(std::max(terrain.height_m({-8, -5}), terrain.height_m({8, -5}))));
  add_foundation(house, plan, level_m, terrain, m);
  float lowest = 1e9f, highest = -1e9f;
  for (const Eigen::Vector3f& p : house.mesh.surfaces[m.stone.material].positions) {
    lowest = std::min(lowest, p.y());
    highest = std::max(highest, p.y());
  }
  const double lowest_ground = std::min(terrain.height_m({-12, -5}), terrain.height_m({12, -5})) - level_m;
  CHECK(lowest < kerb_height_m + lowest_ground - 0.2);
  CHECK(highest == Approx(kerb_height_m).margin(1e-6));  // the landing
  // The doors are 16 m apart on a slope of up to 6 %: the lower door needs steps, the upper one none.
  const double drop = level_m - std::min(terrain.height_m({-8, -5.6}), terrain.height_m({8, -5.6}));
  CHECK(drop > 0.5);
  int treads = 0;
  const Surface& s = house.mesh.surfaces[m.stone.material];
  for (std::size_t t = 0; t < s.indices.size(); t += 3) treads += s.normals[s.indices[t]].y() > 0.99f;
  CHECK(treads == 2 * static_cast<int>(std::ceil(drop / 0.17)));
}
