#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "scenes/city/buildings/building.h"
#include "scenes/city/roadside/furniture/boundary.h"
#include "scenes/city/roadside/furniture/bus_stop.h"
#include "scenes/city/roadside/furniture/goods.h"
#include "scenes/city/roadside/furniture/street_furniture.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/roadside/person.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/roadside/vehicles/bus.h"
#include "scenes/city/roadside/vehicles/lorry.h"
#include "scenes/city/roadside/vehicles/two_wheeler.h"
#include "scenes/city/roadside/vehicles/vehicle.h"
#include "scenes/city/streets/surface/heights.h"

using namespace cps;
using namespace cps::city;

namespace {

struct Box {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
};

Box bounds(const city::Mesh& mesh) {
  Box box;
  for (const auto& [material, surface] : mesh.surfaces)
    for (const Eigen::Vector3f& p : surface.positions) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  return box;
}

/// Checks arrays of equal length, unit normals, indices in range, finite coordinates, and that each normal's
/// cosine with the triangle's front direction is at least `min_cosine`.
void check_sane(const city::Mesh& mesh, double min_cosine) {
  INFO(mesh.name);
  for (const auto& [material, s] : mesh.surfaces) {
    REQUIRE(s.normals.size() == s.positions.size());
    REQUIRE(s.uvs.size() == s.positions.size());
    REQUIRE((s.colors.empty() || s.colors.size() == s.positions.size()));
    REQUIRE(s.indices.size() % 3 == 0);
    for (std::size_t i = 0; i < s.positions.size(); ++i) {
      if (!s.positions[i].allFinite() || !s.uvs[i].allFinite())
        FAIL_CHECK("vertex " << i << " is not finite");
      if (std::abs(s.normals[i].norm() - 1) > 1e-4f)
        FAIL_CHECK("normal " << i << " has length " << s.normals[i].norm());
    }
    for (std::size_t t = 0; t < s.indices.size(); t += 3) {
      REQUIRE(std::max({s.indices[t], s.indices[t + 1], s.indices[t + 2]}) < s.positions.size());
      const Eigen::Vector3f &a = s.positions[s.indices[t]], &b = s.positions[s.indices[t + 1]],
                            &c = s.positions[s.indices[t + 2]];
      const Eigen::Vector3f face = (b - a).cross(c - a).normalized();
      for (int k = 0; k < 3; ++k)
        if (face.dot(s.normals[s.indices[t + k]]) < min_cosine)
          FAIL_CHECK("triangle " << t / 3 << " is inside out");
    }
  }
}

Materials any_materials() {
  Materials m{};
  m.plaster = {{1, 3}};
  m.brick = {{2, 2}, {3, 2}};
  m.concrete = {{4, 3}, {13, 3}};
  m.curtain_wall = {{14, 14.4}};
  m.sheet = {{15, 2}};
  m.gate = {16};
  m.container_paint = {17, 18};
  m.cloth = {19, 20};
  m.skin = {21};
  m.hair = {22};
  m.stone = {5, 3};
  m.glass = 6;
  m.shop_sign = std::vector<MaterialId>(6, 7);
  m.leaves = m.fine_leaves = m.red_leaves = m.needles = {8, 9, 10};
  m.car_paint = {23, 24};
  m.tyre = 11;
  m.rim = 12;
  return m;
}

}  // namespace

TEST_CASE("vehicles have the size of their class, stand on the ground and are not inside out") {
  for (const VehicleClass& c : vehicle_classes()) {
    city::Mesh car = vehicle(c, any_materials(), 20);
    check_sane(car, -0.05);
    const Box box = bounds(car);
    CHECK(box.low.y() == Approx(0).margin(1e-3));
    CHECK(box.high.y() == Approx(c.height_m).margin(0.05));
    CHECK(box.high.x() - box.low.x() == Approx(c.length_m).margin(0.06));
    CHECK(box.high.z() == Approx(c.width_m / 2 + 0.17).margin(0.01));  // with the mirrors
    CHECK(box.high.z() == Approx(-box.low.z()).margin(1e-4));
    CHECK(car.triangle_count() < 6000);
  }
}

TEST_CASE("buses and two-wheelers have realistic sizes, stand on the ground and are not inside out") {
  const Materials m = any_materials();
  const city::Mesh coach = bus(m, 23);
  check_sane(coach, -0.05);
  CHECK(bounds(coach).low.y() == Approx(0).margin(1e-3));
  CHECK(bounds(coach).high.y() == Approx(bus_height_m));
  CHECK(bounds(coach).high.x() - bounds(coach).low.x() == Approx(bus_length_m).margin(0.06));
  CHECK(bounds(coach).high.z() == Approx(bus_width_m / 2 + bus_mirror_m));
  CHECK(bounds(coach).low.z() == Approx(-bounds(coach).high.z()));
  for (int i = 0; i < 10; ++i) {
    const Stream stream = substream(make_stream(9, "two-wheelers"), i);
    for (const city::Mesh& mesh : {bicycle(m, stream), cyclist(m, stream), motorcyclist(m, stream)}) {
      check_sane(mesh, -0.05);
      const Box box = bounds(mesh);
      INFO(mesh.name);
      const bool motor = mesh.name == "motorcyclist";
      CHECK(box.low.y() == Approx(0).margin(2e-3));
      CHECK(box.high.y() > (mesh.name == "bicycle" ? 0.95f : 1.55f));
      CHECK(box.high.y() < (mesh.name == "bicycle" ? 1.15f : 1.9f));
      CHECK(box.high.x() < (motor ? motorcycle_half_length_m : bicycle_half_length_m));
      CHECK(box.low.x() > -(motor ? motorcycle_half_length_m : bicycle_half_length_m));
      CHECK(box.high.z() < (motor ? motorcycle_half_width_m : bicycle_half_width_m));
      CHECK(box.low.z() > -(motor ? motorcycle_half_width_m : bicycle_half_width_m));
      CHECK(mesh.triangle_count() < 4000);
    }
  }
}

TEST_CASE("the shares of the vehicle classes sum to 1") {
  double whole = 0;
  for (const VehicleClass& c : vehicle_classes()) whole += c.share;
  CHECK(whole == Approx(1));
}

TEST_CASE("trees have the size of their species") {
  for (const TreeSpecies& species : tree_species()) {
    const city::Mesh grown = tree(species, 1, 2, make_stream(1, species.name));
    check_sane(grown, -1.01);  // normals of leaves are bent
    const Box box = bounds(grown);
    CHECK(box.high.y() > 0.85 * species.height_m);
    CHECK(box.high.y() < 1.25 * species.height_m + 0.5);
    CHECK(box.high.x() < species.crown_radius_m * 1.2 + 0.9);
    CHECK(grown.surfaces.size() == 2);
    CHECK(grown.triangle_count() < 6000);
  }
}

TEST_CASE("the winding of leaf cards agrees with their normals") {
  const city::Mesh grown = tree(tree_species()[0], 1, 2, make_stream(1, "lime"));
  const Surface& leaves = grown.surfaces.at(1);
  int agreeing = 0;
  const int count = static_cast<int>(leaves.indices.size() / 3);
  for (int t = 0; t < count; ++t) {
    const auto p = [&](int k) { return leaves.positions[leaves.indices[3 * t + k]]; };
    agreeing += (p(1) - p(0)).cross(p(2) - p(0)).dot(leaves.normals[leaves.indices[3 * t]]) > 0;
  }
  CHECK(agreeing == count);
}

TEST_CASE("leaf cards are folded and have different normals at their corners") {
  const city::Mesh grown = tree(tree_species()[0], 1, 2, make_stream(1, "lime"));
  const Surface& leaves = grown.surfaces.at(1);
  double spread_deg = 0, fold_deg = 0;
  const std::size_t cards = leaves.positions.size() / 4;
  REQUIRE(leaves.indices.size() == 6 * cards);
  for (std::size_t card = 0; card < cards; ++card) {
    const auto angle_deg = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      return std::acos(std::clamp(a.dot(b), -1.0f, 1.0f)) * 180 / 3.14159265;
    };
    spread_deg += angle_deg(leaves.normals[4 * card], leaves.normals[4 * card + 2]) / cards;
    const auto face = [&](std::size_t first) {
      const auto p = [&](int k) { return leaves.positions[leaves.indices[first + k]]; };
      return Eigen::Vector3f((p(1) - p(0)).cross(p(2) - p(0)).normalized());
    };
    fold_deg += angle_deg(face(6 * card), face(6 * card + 3)) / cards;
  }
  CHECK(spread_deg > 15);
  CHECK(fold_deg > 20);
  CHECK(fold_deg < 35);
}

TEST_CASE("houses have storeys of realistic height and no face inside out") {
  for (int i = 0; i < 60; ++i) {
    BuildingPlan plan;
    plan.footprint = i % 3 == 0 ? make_footprint({{0, 0}, {18, 0}, {18.5, 17}}, 11)
                                : make_footprint({{0, 0}, {14, 1}}, 10);
    plan.storeys = 2 + i % 7;
    plan.shops = i % 4 == 0;
    plan.detached = i % 2 == 0;
    plan.party_start = plan.party_end = i % 5 == 0;
    plan.roof = i % 3 == 0 ? (i % 2 ? RoofKind::gable : RoofKind::mansard) : static_cast<RoofKind>(i % 4);
    plan.rear_wing_m = i % 3 == 1 ? 5 : 0;
    const city::Mesh house = building(plan, any_materials(), substream(make_stream(9, "house"), i)).mesh;
    check_sane(house, 0.9);
    const Box box = bounds(house);
    CHECK(box.high.y() > plan.storeys * 2.85);
    CHECK(box.high.y() < plan.storeys * 3.5 + 1.2 + 9);
    CHECK(box.low.y() >= static_cast<float>(kerb_height_m) - 0.01f);
  }
}

TEST_CASE("sills and thresholds lie clearly above the wall's face below them") {
  Materials m{};  // every other material is 0
  m.plaster = {{1, 1}};
  m.trim = 2;
  m.stone = {3, 1};
  m.glass = m.curtained_glass = 4;
  FacadeStyle style;
  style.wall = style.ground_wall = m.plaster[0];
  style.frame = 5;
  city::Mesh mesh;
  Draws draws{make_stream(9, "facade")};
  add_facade(mesh, {{0, 0}, {12, 0}, 0.12, 6.1, {0.12, 3.1}, 6.1}, style, GroundFloor::entrance, true, m,
             draws);
  const auto tops = [&](MaterialId material) {  // centroids of faces that look up
    std::vector<Eigen::Vector3f> found;
    const Surface& s = mesh.surfaces[material];
    for (std::size_t t = 0; t < s.indices.size(); t += 3)
      if (s.normals[s.indices[t]].y() > 0.9f)
        found.push_back(
            (s.positions[s.indices[t]] + s.positions[s.indices[t + 1]] + s.positions[s.indices[t + 2]]) / 3);
    return found;
  };
  const std::vector<Eigen::Vector3f> wall = tops(1);
  REQUIRE(wall.size() == 16);  // two triangles for each of eight openings
  int near = 0;
  for (const MaterialId cover : {m.trim, m.stone.material})
    for (const Eigen::Vector3f& top : tops(cover))
      for (const Eigen::Vector3f& below : wall)
        if (std::abs(top.x() - below.x()) < 0.4f && std::abs(top.y() - below.y()) < 0.1f) {
          ++near;
          CHECK(top.y() - below.y() > 0.01f);
        }
  CHECK(near >= 16);
}

TEST_CASE("towers, halls and garages have realistic heights and no face inside out") {
  for (int i = 0; i < 60; ++i) {
    INFO(i);
    BuildingPlan plan;
    plan.kind = i % 3 == 0 ? BuildingKind::tower : i % 3 == 1 ? BuildingKind::hall : BuildingKind::garage;
    const bool is_garage = plan.kind == BuildingKind::garage;
    plan.footprint = is_garage ? make_footprint({{0, 0}, {i % 2 ? 3.3 : 6.0, 0}}, 6.2)
                               : make_footprint({{0, 0}, {24.0 + i % 20, 3}}, 16 + i % 15);
    plan.storeys = plan.kind == BuildingKind::tower ? 6 + i % 26 : 1;
    plan.roof = plan.kind == BuildingKind::tower ? RoofKind::flat
                : is_garage                      ? (i % 2 ? RoofKind::flat : RoofKind::gable)
                : i % 4 == 0                     ? RoofKind::flat
                : i % 4 == 1                     ? RoofKind::gable
                                                 : RoofKind::sawtooth;
    plan.gable_to_street = is_garage;
    const city::Mesh mesh = building(plan, any_materials(), substream(make_stream(9, "building"), i)).mesh;
    check_sane(mesh, 0.9);
    const Box box = bounds(mesh);
    CHECK(box.low.y() >= static_cast<float>(kerb_height_m) - 0.03f);
    if (plan.kind == BuildingKind::tower) {
      CHECK(box.high.y() > plan.storeys * 3.4);
      CHECK(box.high.y() < plan.storeys * 4.0 + 26);
    } else {
      CHECK(box.high.y() > (is_garage ? 2.6 : 5.8));
      CHECK(box.high.y() < (is_garage ? 6.0 : 32.0));
    }
  }
}

TEST_CASE("people and lorries have realistic sizes and stand on the ground") {
  const Materials m = any_materials();
  for (int i = 0; i < 20; ++i) {
    const city::Mesh walker = person(m, substream(make_stream(9, "person"), i));
    check_sane(walker, -0.05);
    CHECK(bounds(walker).low.y() > -0.03f);
    CHECK(bounds(walker).high.y() > 1.5f);
    CHECK(bounds(walker).high.y() < 1.95f);
  }
  const city::Mesh vehicle = lorry(m, 17);
  check_sane(vehicle, -0.05);
  CHECK(bounds(vehicle).low.y() == Approx(0).margin(0.01));
  CHECK(bounds(vehicle).high.y() == Approx(lorry_height_m).margin(0.01));
  CHECK(bounds(vehicle).high.x() - bounds(vehicle).low.x() == Approx(lorry_length_m).margin(0.05));
  CHECK(bounds(vehicle).high.z() < lorry_width_m / 2 + 0.14);  // with its mirrors
}

TEST_CASE("fences and goods have realistic sizes and stand on the ground") {
  const Materials m = any_materials();
  for (const city::Mesh& mesh : {picket_fence(m), mesh_fence(m), low_wall(m), high_wall(m)}) {
    check_sane(mesh, 0.9);
    CHECK(bounds(mesh).high.x() - bounds(mesh).low.x() == Approx(boundary_module_m).margin(0.1));
    CHECK(bounds(mesh).high.y() > 0.9);
    CHECK(bounds(mesh).high.y() < 2.4);
    CHECK(bounds(mesh).low.y() > -0.16f);
  }
  const city::Mesh box = container(m, 17);
  check_sane(box, 0.0);
  CHECK(bounds(box).high.y() == Approx(2.59).margin(0.01));
  CHECK(bounds(box).high.x() - bounds(box).low.x() == Approx(6.06).margin(0.03));
  for (const city::Mesh& mesh : {container_stack(m), pallets(m), silo(m)}) check_sane(mesh, -0.05);
}

TEST_CASE("masts and bus stops have realistic sizes and stand on the pavement") {
  const Materials m = any_materials();
  const city::Mesh shelter = bus_shelter(m), stop = bus_stop_sign(m), wood = telegraph_mast(m),
                   steel = span_mast(m);
  for (const city::Mesh* mesh : {&shelter, &stop, &wood, &steel}) {
    check_sane(*mesh, -0.05);
    CHECK(bounds(*mesh).low.y() == Approx(-0.05f).margin(0.01));
  }
  CHECK(bounds(shelter).high.y() == Approx(2.52).margin(0.05));
  CHECK(bounds(shelter).high.z() < shelter_half_length_m + 0.05);
  CHECK(bounds(shelter).high.x() < shelter_half_depth_m + 0.05);
  CHECK(bounds(stop).high.y() == Approx(2.85).margin(0.05));
  CHECK(bounds(wood).high.y() == Approx(8.25).margin(0.05));
  CHECK(bounds(steel).high.y() == Approx(7.55).margin(0.05));
}

TEST_CASE("street furniture has realistic sizes and stands on the pavement") {
  const Materials m = any_materials();
  const city::Mesh lamp = street_lamp(m, 8, 1.2), box = switch_box(m), light = traffic_light(m, true);
  for (const city::Mesh* mesh : {&lamp, &box, &light}) check_sane(*mesh, -0.05);
  CHECK(bounds(lamp).high.y() == Approx(8).margin(0.2));
  CHECK(bounds(light).high.y() == Approx(3.3).margin(0.1));
  CHECK(bounds(bollard(m)).high.y() == Approx(0.85).margin(0.05));
  CHECK(bounds(bench(m)).high.y() < 0.95f);
  for (const SignKind kind : {SignKind::yield, SignKind::speed, SignKind::parking}) {
    const city::Mesh sign = traffic_sign(m, kind);
    check_sane(sign, -0.05);
    CHECK(bounds(sign).low.y() > -0.06f);
  }
}
