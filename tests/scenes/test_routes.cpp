#include <catch2/catch.hpp>
#include <numbers>

#include "scenes/routes.h"

using namespace cps;
using Eigen::Vector3d;
using Eigen::Vector3f;
using std::numbers::pi;

TEST_CASE("both directions of a street are one route, sorted by street") {
  Scene scene;
  scene.lanes = {{.street = "B", .points = {{0, 0, 0}, {10, 0, 0}}},
                 {.street = "A", .points = {{0, 0, 0}, {0, 0, 3}, {4, 0, 3}}},
                 {.street = "B", .points = {{10, 0, -3}, {0, 0, -3}}}};
  const std::vector<Route> found = routes(scene);
  REQUIRE(found.size() == 2);
  CHECK(found[0].street == "A");
  CHECK(found[0].lanes == std::vector<int>{1});
  CHECK(found[0].length_m == Approx(7));
  CHECK(found[1].lanes == std::vector<int>{0, 2});
  CHECK(found[1].length_m == Approx(20));
}

TEST_CASE("a place on a lane: arc length, tangent heading, left offset") {
  // East for 3 m, then north (−z) for 4 m while climbing 3 m: that part is 5 m long.
  const Lane lane{.street = "A", .points = {{0, 0, 0}, {3, 0, 0}, {3, 3, -4}}};
  CHECK(length_m(lane) == Approx(8));

  const Place east = place_on_lane(lane, 1, 0.5, 0.1);
  CHECK(east.position.isApprox(Vector3d(1, 0, -0.5)));  // left of east is north
  CHECK(east.heading_rad == Approx(0.1));

  const Place north = place_on_lane(lane, 3 + 2.5, -1, 0);
  CHECK(north.position.isApprox(Vector3d(4, 1.5, -2)));  // right of north is east
  CHECK(north.heading_rad == Approx(pi / 2));
  CHECK(north.pitch_rad == Approx(std::atan2(3, 4)));
  CHECK(east.pitch_rad == 0);

  CHECK(place_on_lane(lane, -5, 0, 0).position.norm() == 0);
  CHECK(place_on_lane(lane, 99, 0, 0).position.isApprox(Vector3d(3, 3, -4)));
}

TEST_CASE("places on a circle of many short pieces follow arc length and tangent") {
  Lane circle;
  constexpr int steps = 720;
  constexpr double radius = 50;
  for (int i = 0; i <= steps; ++i) {  // anticlockwise from above: +x towards −z
    const double angle = 2 * pi * i / steps;
    circle.points.push_back(Vector3d(radius * std::cos(angle), 0, -radius * std::sin(angle)).cast<float>());
  }
  for (const double fraction : {0.1, 0.37, 0.8}) {
    const Place place = place_on_lane(circle, fraction * length_m(circle), 0, 0);
    const double angle = 2 * pi * fraction;
    CHECK((place.position - Vector3d(radius * std::cos(angle), 0, -radius * std::sin(angle))).norm() < 0.01);
    CHECK(std::cos(place.heading_rad - (angle + pi / 2)) > std::cos(0.01));
    CHECK((world_from_vehicle(place).linear().col(1) * radius + place.position).norm() <
          0.5);  // left: the centre
  }
}
