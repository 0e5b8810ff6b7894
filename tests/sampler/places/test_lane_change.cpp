#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sampler/places/lane_change.h"

using namespace cps;

namespace {

/// Two lanes to the east, the second 3.5 m to the left (north, −z) of the first, and one back again.
const std::vector<Lane> road = {{"A", 3.5f, {{0, 0, 0}, {200, 0, 0}}, {}},
                                {"A", 3.5f, {{0, 0, -3.5f}, {90, 0, -3.5f}, {200, 0, -3.5f}}, {}},
                                {"A", 3.5f, {{200, 0, -7}, {0, 0, -7}}, {}},
                                {"B", 3.5f, {{0, 0, 3.5f}, {200, 0, 3.5f}}, {}}};

}  // namespace

TEST_CASE("a lane change lies between its lane and the one beside it and heads over") {
  double least = 9, most = 0;
  for (int i = 0; i < 500; ++i) {
    const LaneOffset to_left =
        draw_lane_change(road, 0, 50 + 0.2 * i, substream(make_stream(1, "change"), i));
    CHECK(to_left.lateral_m >= 0);
    CHECK(to_left.lateral_m <= 3.5);
    CHECK(to_left.yaw_rad >= 0);
    CHECK(to_left.yaw_rad <= std::atan(1.5 * 3.5 / 40) + 1e-12);
    least = std::min(least, to_left.lateral_m);
    most = std::max(most, to_left.lateral_m);
    CHECK(draw_lane_change(road, 1, 50, substream(make_stream(1, "change"), i)).lateral_m <= 0);
  }
  CHECK(least < 0.1);
  CHECK(most > 3.4);
}

TEST_CASE("where no lane of the street runs beside in the same direction there is no change") {
  for (const int lane : {2, 3}) CHECK(draw_lane_change(road, lane, 50, make_stream(1, "x")).lateral_m == 0);
}
