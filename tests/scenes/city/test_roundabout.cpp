#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/roundabout.h"
#include "scenes/city/streets/street_grid.h"
#include "tests/scenes/city/all_styles.h"

using namespace cps;
using namespace cps::city;

namespace {

StreetNetwork network_of(CityStyle style, std::uint64_t seed) {
  return draw_street_network({.seed = seed, .style = style, .extent_m = 500});
}

}  // namespace

TEST_CASE("some cities have roundabouts and some have none, and no two roundabouts are neighbours") {
  for (const CityStyle style : all_styles) {
    INFO(to_string(style));
    int with = 0, without = 0;
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const StreetNetwork network = network_of(style, seed);
      int count = 0;
      for (const Junction& j : network.junctions) {
        count += j.roundabout.has_value();
        for (const Side& arm : j.arms)
          CHECK_FALSE((j.roundabout && network.junctions[network.end(arm)].roundabout));
      }
      ++(count > 0 ? with : without);
    }
    if (style != CityStyle::downtown) CHECK(with > 0);  // wide streets leave too little room
    CHECK(without > 0);
  }
}

TEST_CASE("traffic circles a roundabout anticlockwise, clear of its island and of the kerb") {
  int ways = 0;
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      INFO(to_string(style) << " " << seed);
      const StreetNetwork network = network_of(style, seed);
      for (const DrivingLane& lane : driving_lanes(network)) {
        if (lane.junction < 0 || !network.junctions[lane.junction].roundabout) continue;
        ++ways;
        const Junction& j = network.junctions[lane.junction];
        const Roundabout& r = *j.roundabout;
        double turned = 0;
        for (double s = 0; s < length(lane.points); s += 0.5) {
          const Station at = station_at(lane.points, s);
          const Vec2 spoke = at.point - j.position;
          if (spoke.norm() - lane.width_m / 2 < r.island_m + 0.2) FAIL_CHECK("over the island");
          const Vec2 next = station_at(lane.points, s + 0.5).point - j.position;
          turned += std::atan2(cross(spoke, next), spoke.dot(next));
          if (spoke.norm() < (r.outer_m + r.island_m) / 2 + 0.1 && cross(spoke, at.direction) <= 0)
            FAIL_CHECK("the wrong way around");
        }
        CHECK(turned > 0);
        CHECK(turned < 6.2);
      }
    }
  CHECK(ways > 100);
}

TEST_CASE(
    "a roundabout where wide streets meet has two lanes, and traffic from an inner lane uses the inner "
    "lane") {
  int inner = 0, outer = 0;
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
      const StreetNetwork network = network_of(style, seed);
      const std::vector<DrivingLane> lanes = driving_lanes(network);
      for (const DrivingLane& lane : lanes) {
        for (const int next : lane.next) {
          const DrivingLane& way = lanes[next];
          if (way.junction < 0 || !network.junctions[way.junction].roundabout) continue;
          const Roundabout& r = *network.junctions[way.junction].roundabout;
          const StreetProfile& p = network.streets[lane.street].profile;
          const int beside = lane.backward ? p.lanes_backward : p.lanes_forward;
          CHECK(beside <= r.lanes);
          if (r.lanes < 2) continue;
          double nearest = 1e9;
          for (double s = 0; s < length(way.points); s += 0.25)
            nearest = std::min(
                nearest, (station_at(way.points, s).point - network.junctions[way.junction].position).norm());
          const double edge = lane.backward ? p.edge_left_m() : p.edge_right_m();
          const bool at_kerb = lane.right_kerb_m < lane.width_m / 2 + edge + 0.01;
          ++(at_kerb ? outer : inner);
          CHECK(nearest > r.lane_radius_m(at_kerb ? 0 : 1) - 0.1);
        }
      }
    }
  CHECK(inner > 5);
  CHECK(outer > 20);
}

TEST_CASE("at a roundabout every arriving arm is linked to every other arm with a leaving lane") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const StreetNetwork network = network_of(CityStyle::suburb, seed);
    const std::vector<DrivingLane> lanes = driving_lanes(network);
    for (int j = 0; j < static_cast<int>(network.junctions.size()); ++j) {
      if (!network.junctions[j].roundabout) continue;
      std::size_t in = 0, out = 0, both = 0;
      for (const Side& arm : network.junctions[j].arms) {
        const StreetProfile& p = network.profile(arm);
        const bool enters = (arm.reversed ? p.lanes_forward : p.lanes_backward) > 0,
                   leaves = (arm.reversed ? p.lanes_backward : p.lanes_forward) > 0;
        in += enters;
        out += leaves;
        both += enters && leaves;
      }
      std::set<std::pair<int, int>> links;
      for (std::size_t l = 0; l < lanes.size(); ++l)
        for (const int next : lanes[l].next)
          if (lanes[next].junction == j) links.insert({static_cast<int>(l), lanes[next].next.front()});
      CHECK(links.size() == in * out - both);
    }
  }
}

TEST_CASE("kerbs around a roundabout follow its outer radius") {
  int rings = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const StreetNetwork network = network_of(CityStyle::industrial, seed);
    for (const Block& block : network.blocks) {
      const Outline kerb = outline(network, block, std::vector<double>(block.sides.size(), 0.0), 0);
      for (const Junction& j : network.junctions) {
        if (!j.roundabout) continue;
        for (const Vec2& p : kerb.points) {
          const double from_ring = (p - j.position).norm() - j.roundabout->outer_m;
          if (from_ring < -0.01) FAIL_CHECK("a kerb inside the ring");
          rings += std::abs(from_ring) < 0.01;
        }
      }
    }
  }
  CHECK(rings > 100);
}
