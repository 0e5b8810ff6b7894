#include <algorithm>
#include <catch2/catch.hpp>

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/city.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/routes.h"
#include "tests/scenes/city/labelled.h"
#include "tests/temporary_folder.h"

using namespace cps;
using namespace cps::city;
using Eigen::Vector3f;

namespace {

/// What the checks of a city saw, so that none of them is empty.
struct Seen {
  int on_lanes = 0, vehicles = 0, people = 0, houses = 0;
  Names classes;
};

void check_lanes(const Labelled& labelled, Seen& seen) {
  for (const Lane& lane : labelled.scene.lanes) {
    const auto above_lane = [&](double station_m, double lateral_m, float height_m) {
      const Vector3f point = place_on_lane(lane, station_m, lateral_m, 0).position.cast<float>();
      return Vector3f(point + Vector3f(0, height_m, 0));
    };
    const auto is_free = [&](double station_m) {
      return std::none_of(lane.occupied.begin(), lane.occupied.end(), [&](const LaneStretch& o) {
        return o.from_m - 1 < station_m && station_m < o.to_m + 1;
      });
    };
    for (double s = 0.3; s < length_m(lane) - 0.3; s += 2)
      for (const double lateral_m : {-0.75, 0.0, 0.75})  // a tram's rails among them
        if (is_free(s)) {
          ++seen.on_lanes;
          const std::string found = labelled.below(above_lane(s, lateral_m, 0.3f));
          if (found != "road") FAIL_CHECK(lane.street << ", " << s << " m: " << found);
        }
    for (const LaneStretch& stretch : lane.occupied) {
      if (stretch.length_m() < 3 || stretch.length_m() > 10) continue;  // no two-wheeler, no bus in a bay
      ++seen.vehicles;
      const std::string found = labelled.below(above_lane((stretch.from_m + stretch.to_m) / 2, 0, 4.5f));
      if (found != "car" && found != "truck") FAIL_CHECK(lane.street << ": " << found << " in traffic");
    }
  }
}

void check_people(const Labelled& labelled, Seen& seen) {
  int last = -1;
  for (int i = 0; i < static_cast<int>(labelled.scene.instances.size()); ++i) {
    const Instance& instance = labelled.scene.instances[i];
    if (labelled.object(i) != "person" || instance.object == last) continue;
    last = instance.object;
    ++seen.people;  // between whose legs a ray gets through
    const Vector3f foot = instance.world_from_mesh.translation();
    CHECK(labelled.below(foot + Vector3f(0, 0.3f, 0)) == "sidewalk");
  }
}

void check_houses(const Labelled& labelled, const CityOptions& options, Seen& seen) {
  const StreetNetwork network = draw_street_network(options);
  const Districts districts = draw_districts(options);
  for (int b = 0; b < static_cast<int>(network.blocks.size()); ++b) {
    const CityCharacter& character = districts.character_at(block_middle(network, b));
    for (const BuildingPlan& house : plan_block(network, b, character, options.seed).buildings) {
      ++seen.houses;
      const Footprint& f = house.footprint;
      CHECK(labelled.under_the_sky((f.at(0, f.depth_m / 2) + f.at(1, f.depth_m / 2)) / 2) == "building");
    }
  }
}

/// Checks a city's classes against where its lanes, people and houses are.
Seen check_city(const CityOptions& options) {
  const TemporaryFolder folder;
  write_city(options, folder.path / "city.glb");
  const Labelled labelled(folder.path / "city.glb");
  Seen seen;
  Names unlabeled;
  for (int i = 0; i < static_cast<int>(labelled.scene.instances.size()); ++i) {
    seen.classes.insert(labelled.class_of(i));
    if (labelled.classes.of_instance[i] == 0)
      unlabeled.insert(
          labelled.object(i) + " of " +
          labelled.scene.materials[labelled.scene.meshes[labelled.scene.instances[i].mesh].material].name);
  }
  CHECK(unlabeled == Names{});
  check_lanes(labelled, seen);
  check_people(labelled, seen);
  check_houses(labelled, options, seen);
  CHECK(labelled.under_the_sky({3000, 0}) == "terrain");  // beyond all houses and trees
  CHECK(labelled.classes.classes[labelled.classes.background].name == "sky");
  CHECK(seen.on_lanes > 1000);
  CHECK(seen.houses > 20);
  CHECK(seen.people > 5);
  return seen;
}

}  // namespace

TEST_CASE("in a city, roads lie under lanes, sidewalks under people, buildings where they were planned") {
  const Seen seen = check_city({.seed = 7, .style = CityStyle::mixed, .extent_m = 300});
  CHECK(seen.vehicles > 5);
}

TEST_CASE("in every style, the classes are those of what stands where it was planned", "[slow]") {
  Seen all;
  for (const std::string& style : city_style_names()) {
    INFO(style);
    const Seen seen = check_city({.seed = 3, .style = city_style_from(style)});
    all.vehicles += seen.vehicles;
    all.classes.insert(seen.classes.begin(), seen.classes.end());
  }
  CHECK(all.vehicles > 100);
  CHECK(all.classes == Names{"bicycle",       "building",     "bus",        "car",        "dynamic",
                             "fence",         "ground",       "motorcycle", "person",     "pole",
                             "rider",         "road",         "sidewalk",   "static",     "terrain",
                             "traffic light", "traffic sign", "truck",      "vegetation", "wall"});
}
