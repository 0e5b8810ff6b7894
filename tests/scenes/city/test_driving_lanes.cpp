#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/street_grid.h"

using namespace cps;
using namespace cps::city;

namespace {

/// A network of the style that `seed` selects.
StreetNetwork network_of(std::uint64_t seed, double extent_m = 400) {
  return draw_street_network({.seed = seed, .style = static_cast<CityStyle>(seed % 5), .extent_m = extent_m});
}

double turn_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

double sharpest_kink(const Polyline& line) {
  double sharpest = 0;
  for (std::size_t i = 2; i < line.size(); ++i)
    sharpest = std::max(sharpest, turn_between(line[i - 1] - line[i - 2], line[i] - line[i - 1]));
  return sharpest;
}

/// The number of lanes reachable from `first`, itself included.
std::size_t reachable_from(const std::vector<DrivingLane>& lanes, int first) {
  std::vector<bool> seen(lanes.size(), false);
  std::vector<int> open{first};
  seen[first] = true;
  while (!open.empty()) {
    const int lane = open.back();
    open.pop_back();
    for (int next : lanes[lane].next)
      if (!seen[next]) {
        seen[next] = true;
        open.push_back(next);
      }
  }
  return std::count(seen.begin(), seen.end(), true);
}

}  // namespace

TEST_CASE("lanes have realistic widths, keep to the right and stay on the carriageway") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    const std::vector<DrivingLane> all = driving_lanes(network);
    std::set<int> streets;
    for (const DrivingLane& lane : all) {
      streets.insert(lane.street);
      CHECK(lane.width_m >= 3.0);
      CHECK(lane.width_m <= 3.75);
      CHECK(length(lane.points) > 3);
      CHECK(sharpest_kink(lane.points) < 0.15);
      if (lane.junction >= 0) continue;
      const StreetProfile& profile = network.streets[lane.street].profile;
      const bool two_way = profile.lanes_backward > 0;
      for (double s = 1; s < length(lane.points); s += 7) {
        const Station at = station_at(lane.points, s);
        double nearest = 1e9, left_of_lane = 0;
        for (int segment : network.streets[lane.street].segments) {
          const Segment& road = network.segments[segment];
          const double d = distance_to_line(road.centre, at.point);
          if (d >= nearest) continue;
          nearest = d;
          const Station foot = station_at(road.centre, (at.point - road.centre.front()).norm());
          left_of_lane = cross(at.direction, foot.point - at.point);
        }
        CHECK(nearest + lane.width_m / 2 <= profile.half_width() + 0.01);
        if (two_way && profile.parking_left_m == profile.parking_right_m) CHECK(left_of_lane > 0);
      }
    }
    CHECK(streets.size() == network.streets.size());
  }
}

TEST_CASE("no lane reaches over a kerb") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    const std::vector<DrivingLane> all = driving_lanes(network);
    for (const Block& block : network.blocks) {
      const Outline kerb = outline(network, block, std::vector<double>(block.sides.size(), 0.0), 0);
      for (const DrivingLane& lane : all)
        for (double s = 0; s < length(lane.points); s += 3)
          if (distance_to_polygon(kerb.points, station_at(lane.points, s).point) < lane.width_m / 2 - 0.01)
            FAIL_CHECK("street " << network.streets[lane.street].name << " at " << s);
    }
  }
}

TEST_CASE("successors of a lane continue it without a gap or a kink") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const std::vector<DrivingLane> all = driving_lanes(network_of(seed));
    for (const DrivingLane& lane : all) {
      REQUIRE_FALSE(lane.next.empty());
      for (int next : lane.next) {
        const Polyline& on = all[next].points;
        CHECK((on.front() - lane.points.back()).norm() < 1e-6);
        CHECK(turn_between(lane.points.back() - *(lane.points.end() - 2), on[1] - on[0]) < 0.15);
        CHECK((lane.junction < 0) != (all[next].junction < 0));
      }
    }
  }
}

TEST_CASE("every lane is reachable from every other") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const std::vector<DrivingLane> all = driving_lanes(network_of(seed));
    for (std::size_t first = 0; first < all.size(); first += 7)
      REQUIRE(reachable_from(all, static_cast<int>(first)) == all.size());
  }
}

TEST_CASE("every lane is reachable from every other, over twenty seeds of every style", "[slow]") {
  for (const std::string& style : city_style_names())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      INFO(style << " " << seed);
      const std::vector<DrivingLane> all =
          driving_lanes(draw_street_network({.seed = seed, .style = city_style_from(style)}));
      // Strongly connected: from one lane to all, and from all to that one.
      REQUIRE(reachable_from(all, 0) == all.size());
      std::vector<DrivingLane> backwards(all.size());
      for (std::size_t lane = 0; lane < all.size(); ++lane)
        for (const int next : all[lane].next) backwards[next].next.push_back(static_cast<int>(lane));
      REQUIRE(reachable_from(backwards, 0) == all.size());
    }
}
