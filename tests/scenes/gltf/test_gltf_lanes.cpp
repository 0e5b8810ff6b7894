#include <catch2/catch.hpp>
#include <tuple>

#include "tests/scenes/gltf/gltf_maker.h"

using nlohmann::json;

TEST_CASE("lanes from the scene's extras") {
  GltfMaker maker = one_triangle();
  maker.json["scenes"][0]["extras"]["cps_lanes"] = {
      {{"street", "A"},
       {"width_m", 3.5},
       {"points", {{0, 0, 0}, {10, 0.5, -2}}},
       {"next", {1, 0}},
       {"occupied", {{2, 4.5}, {7, 9}}}},
      {{"street", "B"}, {"points", {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}}}};
  const std::vector<cps::Lane> lanes = import_glb(maker).lanes;
  REQUIRE(lanes.size() == 2);
  CHECK(lanes[0].street == "A");
  CHECK(lanes[0].width_m == 3.5f);
  CHECK(lanes[0].points == std::vector<Eigen::Vector3f>{{0, 0, 0}, {10, 0.5f, -2}});
  CHECK(lanes[0].next == std::vector<int>{1, 0});
  REQUIRE(lanes[0].occupied.size() == 2);
  CHECK(lanes[0].occupied[0].to_m == 4.5);
  CHECK(lanes[0].occupied[1].from_m == 7);
  CHECK(lanes[1].next.empty());
  CHECK(lanes[1].occupied.empty());
  CHECK(lanes[1].width_m == 3.25f);
  CHECK(lanes[1].points.size() == 3);
}

TEST_CASE("invalid lanes are refused by name") {
  GltfMaker maker = one_triangle();
  const json good = {{"street", "A"}, {"width_m", 3.5}, {"points", {{0, 0, 0}, {10, 0, 0}}}};
  const auto [pointer, value, line] = GENERATE(table<std::string, json, std::string>({
      {"/street", 5, ".street: must be the name of the lane's street"},
      {"/street", "Main\nStreet",
       ".street: holds a line break or another control character: rename the street"},
      {"/street", "\x7f", ".street: holds a line break or another control character: rename the street"},
      {"/width_m", -1, ".width_m: must be 1 to 20 metres"},
      {"/width_m", "wide", ".width_m: must be 1 to 20 metres"},
      {"/points", json::array({json::array({0, 0, 0})}), ".points: must be at least two points"},
      {"/points", 3, ".points: must be at least two points"},
      {"/points/1", json::array({1, 2}), ".points[1]: must be three finite numbers: x, y, z in metres"},
      {"/points/1", json::array({1, "2", 3}), ".points[1]: must be three finite numbers: x, y, z in metres"},
      {"/points/1", json::array({1, 1e300, 3}),
       ".points[1]: must be three finite numbers: x, y, z in metres"},
      {"/next", json::array({0, 2}), ".next: must be an array of lane numbers, 0 to 1"},
      {"/next", json::array({-1}), ".next: must be an array of lane numbers, 0 to 1"},
      {"/next", json::array({0.5}), ".next: must be an array of lane numbers, 0 to 1"},
      {"/next", "all", ".next: must be an array of lane numbers, 0 to 1"},
      {"/occupied", 7, ".occupied: must be an array of pairs [from, to] in metres, from < to"},
      {"/occupied", json::array({3, 4}),
       ".occupied: must be an array of pairs [from, to] in metres, from < to"},
      {"/occupied", json::array({json::array({4, 3})}),
       ".occupied: must be an array of pairs [from, to] in metres, from < to"},
      {"/points/1", json::array({0, 0, 0}), ".points[1]: repeats the point before it"},
  }));
  json bad = good;
  bad[json::json_pointer(pointer)] = value;
  maker.json["scenes"][0]["extras"]["cps_lanes"] = {good, bad};
  CHECK(refusal(maker) == "scenes[0].extras.cps_lanes[1]" + line);
  maker.json["scenes"][0]["extras"]["cps_lanes"] = "none";
  CHECK(refusal(maker) == "scenes[0].extras.cps_lanes: must be an array of lanes");
}
