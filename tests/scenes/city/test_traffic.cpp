#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "scenes/city/geometry/nearest_station.h"
#include "scenes/city/roadside/kerb_side.h"
#include "scenes/city/roadside/roadside.h"
#include "scenes/city/roadside/traffic.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/city/streets/surface/road_markings.h"
#include "tests/scenes/city/all_styles.h"

using namespace cps;
using namespace cps::city;

namespace {

const ModelLibrary& library() {
  static GlbWriter writer;
  static const ModelLibrary models = make_models(writer, make_materials(writer, 0), 0);
  return models;
}

struct City {
  CityOptions options;
  StreetNetwork network = draw_street_network(options);
  std::vector<DrivingLane> lanes = driving_lanes(network);
  Traffic traffic = draw_traffic(network, lanes, draw_districts(options), library(), options);
};

}  // namespace

TEST_CASE("traffic keeps to its lanes, keeps its distances and stays off crossings, and lanes list it") {
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 400}};
      std::size_t next = 0;
      int queued = 0, alone = 0;
      REQUIRE(city.traffic.occupied.size() == city.lanes.size());
      const std::vector<std::size_t>& at_stops = city.traffic.at_stops;
      std::vector<bool> stops_on;
      for (std::size_t i = 0, first = 0; i < city.lanes.size(); ++i) {
        const std::size_t last = first + city.traffic.occupied[i].size();
        stops_on.push_back(std::any_of(at_stops.begin(), at_stops.end(),
                                       [&](std::size_t bus) { return bus >= first && bus < last; }));
        first = last;
      }
      for (std::size_t i = 0; i < city.lanes.size(); ++i) {
        const DrivingLane& lane = city.lanes[i];
        const auto& occupied = city.traffic.occupied[i];
        if (occupied.empty()) continue;
        REQUIRE(lane.junction == -1);
        const double whole = length(lane.points);
        const Approach start = approach(city.network, lane.segment, lane.backward, seed),
                       end = approach(city.network, lane.segment, !lane.backward, seed);
        if (start.crossing) CHECK(occupied.front().from_m > start.crossing_from_m + start.crossing_length_m);
        CHECK(occupied.front().from_m > 0);
        CHECK(occupied.back().to_m < whole - (end.stop_line ? end.stop_line_at_m + stop_line_width_m : 0));
        if (end.crossing) CHECK(occupied.back().to_m < whole - end.crossing_from_m - end.crossing_length_m);
        for (std::size_t k = 1; k < occupied.size(); ++k) {
          const double gap = occupied[k].from_m - occupied[k - 1].to_m;
          CHECK(gap > 0.9);
          if (!stops_on[i]) CHECK((gap < 2.9 || gap > 14.7));
          ++(gap < 2.9 ? queued : alone);
        }
        // Vehicles are listed lane by lane, the foremost first.
        for (std::size_t k = occupied.size(); k-- > 0; ++next) {
          const PlacedModel& vehicle = city.traffic.vehicles[next];
          CHECK(vehicle.height == 0);
          const bool is_at_stop = std::count(at_stops.begin(), at_stops.end(), next) > 0;
          for (const Vec2& corner : vehicle.footprint()) {
            if (!is_at_stop) CHECK(distance_to_line(lane.points, corner) < lane.width_m / 2 + 0.03);
            const double s = nearest_station(lane.points, corner);
            CHECK(s > occupied[k].from_m);
            CHECK(s < occupied[k].to_m);
          }
          const Station there = station_at(lane.points, (occupied[k].from_m + occupied[k].to_m) / 2);
          const Vec2 looks(std::cos(vehicle.heading_rad), std::sin(vehicle.heading_rad));
          CHECK(looks.dot(there.direction) > 0.95);
        }
      }
      CHECK(next == city.traffic.vehicles.size());
      CHECK(next > 10);
      CHECK(alone > 0);
      if (style == CityStyle::downtown) CHECK(queued > 10);
      for (std::size_t a = 0; a < next; ++a)
        for (std::size_t b = 0; b < a; ++b)
          if ((city.traffic.vehicles[a].position - city.traffic.vehicles[b].position).norm() < 14 &&
              overlap(city.traffic.vehicles[a].footprint(), city.traffic.vehicles[b].footprint(), 0.01))
            FAIL_CHECK(city.traffic.vehicles[a].model->name << " in "
                                                            << city.traffic.vehicles[b].model->name);
    }
}

TEST_CASE("buses at stops stand at the sign, between the kerb and the next lane, and lanes list them") {
  int buses = 0;
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 400, .traffic = 1.5}};
      std::vector<std::size_t> lane_of;  // by vehicle
      for (std::size_t i = 0; i < city.lanes.size(); ++i)
        lane_of.insert(lane_of.end(), city.traffic.occupied[i].size(), i);
      for (const std::size_t index : city.traffic.at_stops) {
        ++buses;
        const PlacedModel& bus = city.traffic.vehicles[index];
        const DrivingLane& lane = city.lanes[lane_of[index]];
        const Segment& segment = city.network.segments[lane.segment];
        const KerbSide kerb = kerb_side(city.network, {lane.segment, !lane.backward}, 0, city.options);
        CHECK(bus.model->name == "bus");
        REQUIRE(kerb.bus_stop);
        const Vec2 nose = bus.position +
                          Vec2(std::cos(bus.heading_rad), std::sin(bus.heading_rad)) * bus.model->half_length;
        CHECK(nearest_station(kerb.centre, nose) == Approx(kerb.bus_stop->sign_m).margin(0.6));
        for (const Vec2& corner : bus.footprint()) {
          CHECK(distance_to_line(segment.centre, corner) < segment.half_width);  // not over the kerb
          const Station there = station_at(lane.points, nearest_station(lane.points, corner));
          CHECK(cross(there.direction, corner - there.point) <
                lane.width_m / 2 + 0.01);  // and not in the next lane
        }
        const double middle = nearest_station(lane.points, bus.position);
        CHECK(std::any_of(
            city.traffic.occupied[lane_of[index]].begin(), city.traffic.occupied[lane_of[index]].end(),
            [&](const OccupiedStretch& o) { return o.from_m < middle - 5.9 && o.to_m > middle + 5.9; }));
      }
    }
  CHECK(buses > 20);
}

TEST_CASE("cyclists use cycle tracks where there are any") {
  int on_tracks = 0;
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 400}};
      for (const PlacedModel& rider : city.traffic.on_tracks) {
        ++on_tracks;
        const Vec2 ahead(std::cos(rider.heading_rad), std::sin(rider.heading_rad));
        double nearest = 1e9, agreement = 0;
        for (const DrivingLane& lane : city.lanes) {
          if (lane.junction >= 0) continue;
          for (const Vec2& corner : rider.footprint()) {
            const double room = distance_to_line(lane.points, corner) - lane.width_m / 2;
            if (room < 0.05) FAIL_CHECK("on a lane");
          }
          const double d = distance_to_line(lane.points, rider.position);
          if (d >= nearest) continue;
          nearest = d;
          agreement =
              station_at(lane.points, nearest_station(lane.points, rider.position)).direction.dot(ahead);
        }
        CHECK(agreement > 0.9);  // in the direction of the traffic beside it
        double from_kerb = -1e9;
        for (const Segment& segment : city.network.segments)
          if (segment.street >= 0)
            from_kerb =
                std::max(from_kerb, segment.half_width - distance_to_line(segment.centre, rider.position));
        CHECK(from_kerb > rider.model->half_width);
      }
      for (std::size_t i = 0, next = 0; i < city.lanes.size(); ++i)
        for (std::size_t k = 0; k < city.traffic.occupied[i].size(); ++k, ++next) {
          const StreetProfile& p = city.network.streets[city.lanes[i].street].profile;
          if ((city.lanes[i].backward ? p.cycle_left_m : p.cycle_right_m) > 0)
            CHECK(city.traffic.vehicles[next].model->name != "cyclist");
        }
    }
  CHECK(on_tracks > 100);
}

TEST_CASE("traffic does not overlap anything along the streets") {
  for (const CityStyle style : all_styles) {
    INFO(to_string(style));
    const City city{{.seed = 5, .style = style, .extent_m = 300}};
    const Districts districts = draw_districts(city.options);
    for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b) {
      const CityCharacter& character = districts.character_at(block_middle(city.network, b));
      const BlockPlan plan = plan_block(city.network, b, character, city.options.seed);
      for (const PlacedModel& placed : furnish(city.network, b, plan, library(), character, city.options))
        for (const auto* vehicles : {&city.traffic.vehicles, &city.traffic.on_tracks})
          for (const PlacedModel& vehicle : *vehicles)
            if ((placed.position - vehicle.position).norm() < 14 &&
                overlap(placed.footprint(), vehicle.footprint(), 0.02))
              FAIL_CHECK(vehicle.model->name << " in " << placed.model->name);
    }
  }
}

TEST_CASE("another traffic seed changes traffic, parked cars and people, and nothing else") {
  for (const CityStyle style : {CityStyle::european, CityStyle::suburb, CityStyle::industrial}) {
    INFO(to_string(style));
    const City monday{{.seed = 4, .style = style}}, tuesday{{.seed = 4, .traffic_seed = 1, .style = style}};
    REQUIRE(monday.lanes.size() == tuesday.lanes.size());
    std::size_t same = 0, either = 0;
    for (std::size_t i = 0; i < monday.lanes.size(); ++i) {
      CHECK(monday.lanes[i].points == tuesday.lanes[i].points);
      const auto &a = monday.traffic.occupied[i], &b = tuesday.traffic.occupied[i];
      for (const OccupiedStretch& x : a)
        same += std::any_of(b.begin(), b.end(), [&](const OccupiedStretch& y) {
          return std::abs(x.from_m - y.from_m) < 0.05 && std::abs(x.to_m - y.to_m) < 0.05;
        });
      either += a.size() + b.size();
    }
    CHECK(either > 100);
    CHECK(same < either / 50 + monday.traffic.at_stops.size());  // buses share their stops
    using Standing = std::vector<std::pair<std::string, Vec2>>;
    const auto standing = [&](const City& city, bool moving) {
      Standing all;
      const Districts districts = draw_districts(city.options);
      for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b) {
        const CityCharacter& character = districts.character_at(block_middle(city.network, b));
        const BlockPlan plan = plan_block(city.network, b, character, city.options.seed);
        for (const PlacedModel& p : furnish(city.network, b, plan, library(), character, city.options)) {
          const bool moves = (p.model->kind == ModelKind::car && p.model->name != "lorry") ||
                             p.model->kind == ModelKind::cyclist || p.model->kind == ModelKind::person;
          if (moves == moving && p.model->name.find("traffic light") != 0)
            all.emplace_back(p.model->name, p.position);
        }
      }
      return all;
    };
    CHECK(standing(monday, false) == standing(tuesday, false));
    const Standing a = standing(monday, true), b = standing(tuesday, true);
    CHECK(a.size() > 50);
    std::size_t stayed = 0;
    for (const auto& car : a) stayed += std::count(b.begin(), b.end(), car);
    CHECK(stayed < a.size() / 10);
  }
}

TEST_CASE("traffic follows its option, and downtown has more of it than a suburb") {
  const auto per_km = [](CityStyle style, double traffic) {
    double vehicles = 0, km = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const City city{{.seed = seed, .style = style, .traffic = traffic}};
      vehicles += static_cast<double>(city.traffic.vehicles.size());
      for (const DrivingLane& lane : city.lanes)
        if (lane.segment >= 0) km += length(lane.points) / 1000;
    }
    return vehicles / km;
  };
  CHECK(per_km(CityStyle::european, 0) == 0);
  CHECK(per_km(CityStyle::european, 0.5) < 0.7 * per_km(CityStyle::european, 1));
  CHECK(per_km(CityStyle::downtown, 1) > 2 * per_km(CityStyle::suburb, 1));
}
