#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "sampler/places/place_draw.h"
#include "tests/sampler/plain_scene.h"

using namespace cps;

namespace {

/// Streets that cross: on each, a lane of 60 m, a way of 5 m through a junction, and a lane of 60 m more.
Scene linked_scene(int streets) {
  Scene scene = plain_scene(0);
  for (int s = 0; s < streets; ++s) {
    const float z = -100.0f + 20.0f * static_cast<float>(s);
    const std::string street = "street " + std::to_string(s);
    const int first = static_cast<int>(scene.lanes.size());
    scene.lanes.push_back({street, 3.5f, {{-60, 0, z}, {0, 0, z}}, {first + 1}});
    scene.lanes.push_back({street, 3.5f, {{0, 0, z}, {5, 0, z}}, {first + 2}});
    scene.lanes.push_back({street, 3.5f, {{5, 0, z}, {65, 0, z}}, {}});
  }
  return scene;
}

}  // namespace

TEST_CASE("places lie as thick in a junction as before and behind it") {
  Recipe recipe;
  recipe.lateral_m = recipe.heading_deg = 0;
  const DrivableScene scene = drivable_scene(linked_scene(6), "linked", recipe, make_stream(1, "streets"));
  constexpr int places = 4000;
  int in_junction = 0, near_it = 0;
  for (int i = 0; i < places; ++i) {
    const double x = draw_place(scene, Rig{}, Part::train, recipe, {}, substream(make_stream(3, "place"), i))
                         .place.position.x();
    CHECK(x >= -57);  // 3 m from where the street begins and ends
    CHECK(x <= 62);
    in_junction += x >= 0 && x < 5;
    near_it += x >= -3 && x < 8;
  }
  // 5 and 11 of 119 m, within four standard deviations.
  const auto expected = [](double metres) { return places * metres / 119; };
  const auto sd = [&](double metres) { return std::sqrt(expected(metres) * (1 - metres / 119)); };
  CHECK(std::abs(in_junction - expected(5)) < 4 * sd(5));
  CHECK(std::abs(near_it - expected(11)) < 4 * sd(11));
}

TEST_CASE("a turn into another part's street is driven to its middle, so no place has a twin there") {
  const std::vector<Lane> lanes = {
      {"A", 3, {{0, 0, 0}, {50, 0, 0}}, {1, 2}}, {"A", 3, {{50, 0, 0}, {62, 0, 0}}, {3}},
      {"A", 3, {{50, 0, 0}, {58, 0, 6}}, {4}},   {"A", 3, {{62, 0, 0}, {90, 0, 0}}, {}},
      {"B", 3, {{58, 0, 6}, {58, 0, 100}}, {5}}, {"C", 3, {{58, 0, 100}, {58, 0, 130}}, {}}};
  const std::vector<Part> parts = {Part::train, Part::train, Part::train, Part::train, Part::test, Part::val};
  const std::vector<LaneStretch> usable = usable_stretches(lanes, parts);
  const auto check = [&](int lane, double from_m, double to_m) {
    INFO("lane " << lane);
    CHECK(usable[lane].from_m == Approx(from_m).margin(1e-9));
    CHECK(usable[lane].to_m == Approx(to_m));
  };
  check(0, 3, 50);  // starts without a link
  check(1, 0, 12);  // straight on, the same street
  check(2, 0, 5);   // 10 m long, into B
  check(3, 0, 25);  // ends without a link
  check(4, 0, 84);  // leads into another street
  check(5, 0, 27);
  const std::vector<Part> shared(lanes.size(), Part::all);
  CHECK(usable_stretches(lanes, shared)[2].to_m == Approx(10));
}

TEST_CASE("a lane shorter than its margins has no place") {
  const std::vector<Lane> lanes = {{"A", 3, {{0, 0, 0}, {5, 0, 0}}, {}}};
  const std::vector<Part> parts = {Part::train};
  CHECK(usable_stretches(lanes, parts)[0].length_m() == 0);
}

TEST_CASE("cameras are turned uniformly within the recipe's ranges and all else stays as drawn") {
  Recipe straight, turned;
  turned.camera_pitch_min_deg = -15;
  turned.camera_pitch_max_deg = 5;
  turned.camera_roll_min_deg = -10;
  turned.camera_roll_max_deg = 10;
  const DrivableScene scene = drivable_scene(plain_scene(6), "plain", straight, make_stream(1, "streets"));
  constexpr int places = 2000;
  double pitch_sum = 0, roll_sum = 0, pitch_squares = 0;
  for (int i = 0; i < places; ++i) {
    const Stream stream = substream(make_stream(5, "place"), i);
    const auto camera = [&](const Recipe& recipe) {
      return draw_place(scene, Rig{}, Part::train, recipe, {}, stream).cameras.at(0);
    };
    const RigCamera plain = camera(straight), moved = camera(turned);
    CHECK(moved.yaw_deg == plain.yaw_deg);
    CHECK((moved.position_m == plain.position_m));
    const double pitch = moved.pitch_deg - plain.pitch_deg, roll = moved.roll_deg - plain.roll_deg;
    CHECK((pitch >= -15 - 1e-9 && pitch <= 5 + 1e-9));
    CHECK((roll >= -10 - 1e-9 && roll <= 10 + 1e-9));
    pitch_sum += pitch;
    roll_sum += roll;
    pitch_squares += (pitch + 5) * (pitch + 5);
  }
  // Means of −5 and 0 and a variance of 20²/12, within four standard deviations of their estimates.
  const double sd = 20 / std::sqrt(12.0);
  CHECK(std::abs(pitch_sum / places + 5) < 4 * sd / std::sqrt(places));
  CHECK(std::abs(roll_sum / places) < 4 * sd / std::sqrt(places));
  CHECK(std::abs(pitch_squares / places - sd * sd) < 4 * sd * sd * std::sqrt(.8 / places));
}
