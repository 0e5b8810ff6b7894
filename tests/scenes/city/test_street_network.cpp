#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/city/streets/street_network.h"

using namespace cps;
using namespace cps::city;

namespace {

/// A network of the style that `seed` selects.
StreetNetwork network_of(std::uint64_t seed, double extent_m = 400) {
  return draw_street_network({.seed = seed, .style = static_cast<CityStyle>(seed % 5), .extent_m = extent_m});
}

}  // namespace

TEST_CASE("every seed gives a planar network with enough streets for splits") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    INFO("seed " << seed);
    const StreetNetwork network = network_of(seed);
    CHECK(network.streets.size() >= 8);
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
          24);  // at least three corners of eight pieces each
  }
}

TEST_CASE("different seeds give different networks") {
  const StreetNetwork a = network_of(1), b = network_of(2);
  CHECK((a.rim[0] - b.rim[0]).norm() > 1);
  CHECK(a.junctions.size() + a.blocks.size() * 1000 + a.streets.size() * 1000000 !=
        b.junctions.size() + b.blocks.size() * 1000 + b.streets.size() * 1000000);
}
