#include <catch2/catch.hpp>

#include "sampler/places/place_draw.h"
#include "tests/sampler/plain_scene.h"

using namespace cps;

namespace {

/// One lane along x from 0 to 100 m, and a vehicle from 40 to 44 m.
std::vector<Lane> lane_with_vehicle() {
  Lane lane{"A", 3.25f, {{0, 0, 0}, {100, 0, 0}}, {}, {}};
  lane.occupied.push_back({40, 44});
  return {lane};
}

}  // namespace

TEST_CASE("a car keeps 1 m behind it and 4 m before it free of vehicles on the lanes") {
  const std::vector<Lane> lanes = lane_with_vehicle();
  const LaneTraffic traffic = traffic_on(lanes);
  const auto is_clear = [&](double x, double left, double heading = 0) {
    return is_clear_of(traffic, place_on_lane(lanes[0], x, left, heading));
  };
  CHECK(is_clear(40 - 3.7 - 4 - 0.01, 0));
  CHECK_FALSE(is_clear(40 - 3.7 - 4 + 0.01, 0));
  CHECK_FALSE(is_clear(42, 0));
  CHECK_FALSE(is_clear(44 + 1.1 + 1 - 0.01, 0));
  CHECK(is_clear(44 + 1.1 + 1 + 0.01, 0));
  CHECK_FALSE(is_clear(42, 1.5));   // changing lanes
  CHECK(is_clear(42, 3));           // in the next lane
  CHECK(is_clear(33, 0, 0.6));      // turning off before it
  CHECK_FALSE(is_clear(38, 0, 3));  // turned round, 3.1 m behind it
  CHECK(is_clear_of(traffic_on(std::vector<Lane>(1)), Place{}));
}

TEST_CASE("what the lanes call occupied is held within them, however long it claims to be") {
  std::vector<Lane> lanes = lane_with_vehicle();
  lanes[0].occupied = {{-1e300, 1e300}, {200, 300}};
  const LaneTraffic traffic = traffic_on(lanes);
  CHECK(traffic.points.size() == 202);
  for (const Eigen::Vector3d& p : traffic.points) CHECK((p.x() >= 0 && p.x() <= 100));
}

TEST_CASE("no drawn place lies in traffic, and what is passed over is no rejection") {
  Recipe recipe;
  recipe.split = "thesis";
  Scene scene = plain_scene(1);  // two lanes of 300 m
  for (Lane& lane : scene.lanes)
    for (double s = 0; s < 290; s += 30) lane.occupied.push_back({s, s + 12});
  const DrivableScene drivable = drivable_scene(scene, "plain", recipe, make_stream(1, "streets"));
  PlaceTally tally;
  std::array<int, 2> by_lane{};
  constexpr int places = 2000;
  for (int i = 0; i < places; ++i) {
    const DrawnPlace drawn =
        draw_place(drivable, Rig{}, Part::all, recipe, {}, substream(make_stream(3, "place"), i));
    tally.add(drawn.tally);
    const bool eastwards = std::cos(drawn.place.heading_rad) > 0;
    ++by_lane[eastwards];
    const double s = eastwards ? drawn.place.position.x() + 150 : 150 - drawn.place.position.x();
    const double behind = std::fmod(s, 30);  // distance from a vehicle's rear; its front is at 12
    // Stretches of 30 − 12 − 9.8 m remain; a slight turn may move the bumpers by centimetres.
    if (s < 290 && (behind < 12 + 2.1 - 0.2 || behind > 30 - 7.7 + 0.2) && s > 2.1)
      FAIL_CHECK("a place " << behind << " m behind a vehicle's rear");
  }
  CHECK(tally.rejected() == 0);
  CHECK(std::abs(by_lane[0] - places / 2) < 4 * std::sqrt(places / 4.0));
}
