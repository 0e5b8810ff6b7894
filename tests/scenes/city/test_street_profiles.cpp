#include <catch2/catch.hpp>
#include <set>

#include "scenes/city/geometry/nearest_station.h"
#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/city/streets/street_profiles.h"
#include "scenes/city/streets/surface/cycle_tracks.h"
#include "scenes/city/streets/surface/median.h"
#include "scenes/city/streets/surface/road_markings.h"
#include "scenes/city/streets/surface/tram_tracks.h"
#include "tests/scenes/city/all_styles.h"

using namespace cps;
using namespace cps::city;

namespace {

StreetProfile profile_of(CityStyle style, std::uint64_t seed) {
  Draws draws{make_stream(seed, "profile test")};
  return draw_street_profile(draws, style, false);
}

}  // namespace

TEST_CASE("parking bays, cycle tracks, lanes and median fill the carriageway without overlap") {
  int cycles = 0, medians = 0, trams = 0;
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const StreetProfile p = profile_of(style, seed);
      double left = -p.half_width() + p.parking_right_m + p.cycle_right_m;
      for (int lane = 0; lane < p.lanes_forward; ++lane, left += p.lane_width_m)
        CHECK(p.forward_lane_offset(lane) == Approx(left + p.lane_width_m / 2).margin(1e-9));
      if (p.lanes_backward > 0) CHECK(p.divider_offset() == Approx(left + p.median_m / 2).margin(1e-9));
      left += p.median_m;
      for (int lane = p.lanes_backward - 1; lane >= 0; --lane, left += p.lane_width_m)
        CHECK(p.backward_lane_offset(lane) == Approx(left + p.lane_width_m / 2).margin(1e-9));
      CHECK(left + p.cycle_left_m + p.parking_left_m == Approx(p.half_width()));
      for (const double cycle_m : {p.cycle_left_m, p.cycle_right_m}) {
        CHECK((cycle_m == 0 || (cycle_m >= 1.5 && cycle_m <= 1.85)));
        cycles += cycle_m > 0;
      }
      CHECK_FALSE((p.median_m > 0 && p.tram_tracks));
      if (p.median_m > 0 || p.tram_tracks) CHECK(std::min(p.lanes_forward, p.lanes_backward) >= 2);
      medians += p.median_m > 0;
      trams += p.tram_tracks;
    }
  CHECK(cycles > 50);
  CHECK(medians > 20);
  CHECK(trams > 20);
}

TEST_CASE("crossings of streets with a median have refuge islands, clear of lanes and of the crossing") {
  int noses = 0;
  for (const CityStyle style : {CityStyle::european, CityStyle::downtown})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      INFO(to_string(style) << " " << seed);
      const StreetNetwork network = draw_street_network({.seed = seed, .style = style, .extent_m = 500});
      const std::vector<DrivingLane> lanes = driving_lanes(network);
      for (const Street& street : network.streets)
        for (const int s : street.segments)
          for (const bool at_end : {false, true}) {
            const Approach a = approach(network, s, at_end, seed);
            const Polygon nose = refuge_nose(network, s, at_end, seed);
            CHECK(nose.empty() == (street.profile.median_m == 0 || !a.crossing));
            if (nose.empty()) continue;
            ++noses;
            CHECK(signed_area(nose) > 0.4);
            const Segment& segment = network.segments[s];
            for (const Vec2& corner : nose) {
              const double station = nearest_station(segment.centre, corner);
              CHECK((at_end ? length(segment.centre) - segment.cut_to - station
                            : station - segment.cut_from) < a.crossing_from_m - 0.1);
              for (const DrivingLane& lane : lanes)
                if (distance_to_line(lane.points, corner) < lane.width_m / 2 + 0.05)
                  FAIL_CHECK("over a lane by " << lane.width_m / 2 - distance_to_line(lane.points, corner));
            }
          }
    }
  CHECK(noses > 20);
}

TEST_CASE("tram tracks lie in the innermost lanes, run with the traffic and have the right gauge") {
  Materials m{};
  m.rail = 1;
  m.tar = 2;
  m.manhole = 3;
  int tracks = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const StreetNetwork network =
        draw_street_network({.seed = seed, .style = CityStyle::downtown, .extent_m = 500});
    const std::vector<DrivingLane> lanes = driving_lanes(network);
    for (const TramTrack& track : tram_tracks(network)) {
      ++tracks;
      int beside = 0;
      for (const DrivingLane& lane : lanes) {
        if (lane.street != track.street || lane.junction >= 0) continue;
        const Station at = station_at(lane.points, length(lane.points) / 2);
        if (distance_to_line(track.centre, at.point) > 0.3) continue;
        ++beside;
        double nearest = 1e9;
        Vec2 along(0, 0);
        for (double s = 0; s < length(track.centre); s += 2) {
          const Station on = station_at(track.centre, s);
          if ((on.point - at.point).norm() >= nearest) continue;
          nearest = (on.point - at.point).norm();
          along = on.direction;
        }
        CHECK(along.dot(at.direction) > 0.99);
      }
      CHECK(beside == static_cast<int>(network.streets[track.street].segments.size()));
      Mesh rails = tram_rails(track, m);
      double inner = 1e9;  // distance of the rails' inner faces from the middle
      for (const Eigen::Vector3f& p : rails.surfaces[m.rail].positions)
        inner = std::min(inner, distance_to_line(track.centre, {p.x(), -p.z()}));
      CHECK(2 * inner == Approx(tram_gauge_m).margin(0.01));
    }
  }
  CHECK(tracks > 4);
}

TEST_CASE("a median does not reach into lanes, including those across junctions") {
  const Materials m{};
  int medians = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const StreetNetwork network =
        draw_street_network({.seed = seed, .style = CityStyle::downtown, .extent_m = 500});
    const std::vector<DrivingLane> lanes = driving_lanes(network);
    for (int s = 0; s < static_cast<int>(network.streets.size()); ++s) {
      const Mesh mesh = median(network, s, m, seed);
      if (mesh.empty()) continue;
      ++medians;
      for (const auto& [material, surface] : mesh.surfaces)
        for (const Eigen::Vector3f& p : surface.positions)
          for (const DrivingLane& lane : lanes) {
            const Vec2 plan(p.x(), -p.z());
            if ((lane.points.front() - plan).norm() > 250) continue;
            if (distance_to_line(lane.points, plan) < lane.width_m / 2 - 0.01)
              FAIL_CHECK("street " << network.streets[s].name);
          }
    }
  }
  CHECK(medians > 1);
}
