#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "scenes/city/streets/street_network.h"

using namespace cps;
using namespace cps::city;

namespace {

StreetNetwork network_of(std::uint64_t seed, double extent_m = 400) {
  return draw_street_network({.seed = seed, .extent_m = extent_m});
}

}  // namespace

TEST_CASE("every seed gives a planar network with enough streets to split") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    CHECK(network.streets.size() >= 12);
    // Euler: vertices − edges + bounded faces = 1 for a connected planar graph.
    CHECK(static_cast<int>(network.junctions.size()) - static_cast<int>(network.segments.size()) +
              static_cast<int>(network.blocks.size()) ==
          1);
    double blocks = 0;
    for (const Block& block : network.blocks) {
      Polygon corners;
      for (const Side& side : block.sides) {
        const Polyline line = network.line(side, 0);
        corners.insert(corners.end(), line.begin(), line.end() - 1);
      }
      blocks += signed_area(corners);
    }
    CHECK(blocks == Approx(signed_area(network.rim)).epsilon(1e-9));
    std::set<std::string> names;
    for (const Street& street : network.streets) names.insert(street.name);
    CHECK(names.size() == network.streets.size());
  }
}

TEST_CASE("streets leave room for the blocks between them") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    for (const Segment& segment : network.segments) {
      if (segment.street < 0) continue;
      CHECK(length(segment.centre) > 40);
      CHECK(segment.cut_from + segment.cut_to < 0.75 * length(segment.centre));
      CHECK(segment.cut_from >= 0);
    }
  }
}

TEST_CASE("lanes have real widths, keep to the right and stay on the carriageway") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    const std::vector<DrivingLane> all = lanes(network);
    std::set<int> streets;
    for (const DrivingLane& lane : all) {
      streets.insert(lane.street);
      CHECK(lane.width_m >= 3.0);
      CHECK(lane.width_m <= 3.75);
      CHECK(length(lane.points) > 20);
      for (std::size_t i = 2; i < lane.points.size(); ++i) {  // no kink a car could not drive
        const Vec2 a = lane.points[i - 1] - lane.points[i - 2], b = lane.points[i] - lane.points[i - 1];
        CHECK(std::abs(std::atan2(cross(a, b), a.dot(b))) < 0.15);
      }
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

TEST_CASE("no lane comes near a kerb") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    const std::vector<DrivingLane> all = lanes(network);
    for (const Block& block : network.blocks) {
      const Outline kerb = outline(network, block, std::vector<double>(block.sides.size(), 0.0), 0);
      for (const DrivingLane& lane : all)
        for (double s = 0; s < length(lane.points); s += 3)
          if (distance_to_polygon(kerb.points, station_at(lane.points, s).point) < lane.width_m / 2 - 0.01)
            FAIL_CHECK("street " << network.streets[lane.street].name << " at " << s);
    }
  }
}

TEST_CASE("kerbs of one block are parallel rings with rounded corners") {
  const StreetNetwork network = network_of(3);
  for (const Block& block : network.blocks) {
    if (block.at_rim) continue;
    const std::vector<double> kerb_inset(block.sides.size(), 0.0), back_inset(block.sides.size(), 0.15);
    const Outline kerb = outline(network, block, kerb_inset, 0),
                  back = outline(network, block, back_inset, 0.15);
    REQUIRE(kerb.points.size() == back.points.size());
    for (std::size_t i = 0; i < kerb.points.size(); ++i)
      CHECK((kerb.points[i] - back.points[i]).norm() == Approx(0.15).epsilon(0.03));
    CHECK(signed_area(kerb.points) > signed_area(back.points));
    CHECK(std::count(kerb.corner.begin(), kerb.corner.end(), true) >=
          24);  // three corners at least, eight pieces each
  }
}

TEST_CASE("seeds are different places") {
  const StreetNetwork a = network_of(1), b = network_of(2);
  CHECK((a.rim[0] - b.rim[0]).norm() > 1);
  CHECK(a.junctions.size() + a.blocks.size() * 1000 + a.streets.size() * 1000000 !=
        b.junctions.size() + b.blocks.size() * 1000 + b.streets.size() * 1000000);
}
