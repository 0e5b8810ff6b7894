#include "scenes/city/roadside/traffic.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scenes/city/geometry/nearest_station.h"
#include "scenes/city/roadside/furniture/signals.h"
#include "scenes/city/roadside/kerb_side.h"

namespace cps::city {
namespace {

constexpr double bus_at_stop_share = 0.4;
constexpr double slack_m = 0.1;  ///< added to stretches, because a chord is shorter than its arc
/// Gaps from bumper to bumper, in a queue and between moving vehicles.
constexpr double queue_gap_min_m = 1.2, queue_gap_max_m = 2.8, headway_min_m = 15, headway_max_m = 60;
constexpr double before_stop_line_min_m = 0.3, before_stop_line_max_m = 1.2, behind_crossing_m = 1,
                 before_crossing_m = 1;

/// The traffic density of a style.
struct TrafficDensity {
  double lane_share;   ///< of lanes with traffic
  double queue_share;  ///< of those ending at a stop line without a traffic light: with a queue
  double headway_m;    ///< on average
};

TrafficDensity density(CityStyle style) {
  switch (style) {
    case CityStyle::downtown:
      return {0.85, 0.35, 26};
    case CityStyle::suburb:
      return {0.35, 0.2, 42};
    case CityStyle::industrial:
      return {0.5, 0.25, 36};
    case CityStyle::european:
    case CityStyle::mixed:
      break;
  }
  return {0.65, 0.3, 32};
}

/// A random headway between the minimum and the maximum, with the given mean; short ones are more frequent.
double draw_headway(Draws& draws, double mean) {
  const double t = (mean - headway_min_m) / (headway_max_m - headway_min_m);
  return std::lerp(headway_min_m, headway_max_m, std::pow(draws.uniform(0, 1), 1 / t - 1));
}

const Model& draw_vehicle(Draws& draws, const ModelLibrary& models, CityStyle style, bool has_cycle_track) {
  const bool works = style == CityStyle::industrial, centre = style == CityStyle::downtown;
  const double pick = draws.uniform(0, 1), lorries = works ? 0.2 : 0.05, buses = centre ? 0.08 : 0.05;
  if (pick < lorries) return draws.one_of(models.lorries);
  if (pick < lorries + buses) return draws.one_of(models.buses);
  if (pick < lorries + buses + 0.04) return draws.one_of(models.motorcyclists);
  if (pick < lorries + buses + 0.12 && !has_cycle_track) return draws.one_of(models.cyclists);
  return draw_car(draws, models);
}

/// A bus at a stop, and the stretch of lane it occupies.
struct BusAtStop {
  PlacedModel bus;
  OccupiedStretch stretch;
};

/// A bus at the stop beside a lane: as close to the kerb as possible, its front at the sign. None if the lane
/// is not next to the kerb, there is no stop, no bus is drawn, or the street bends too much.
std::optional<BusAtStop> draw_bus_at_stop(const StreetNetwork& network, const DrivingLane& lane,
                                          const ModelLibrary& models, const CityOptions& options,
                                          Draws draws) {
  constexpr double kerb_gap_m = 0.1;
  const Side side{lane.segment, !lane.backward};  // the side's block is on the lane's right
  const StreetProfile& profile = network.profile(side);
  const double parking = lane.backward ? profile.parking_left_m : profile.parking_right_m,
               edge = lane.backward ? profile.edge_left_m() : profile.edge_right_m();
  if (lane.right_kerb_m > lane.width_m / 2 + edge + 0.01)
    return std::nullopt;  // another lane is next to the kerb
  const KerbSide kerb = kerb_side(network, side, 0, options);
  if (!kerb.bus_stop || !draws.chance(std::min(1.0, bus_at_stop_share * options.traffic)))
    return std::nullopt;
  const Model& model = draws.one_of(models.buses);
  const double nose = nearest_station(lane.points, kerb.at(kerb.bus_stop->sign_m, 0)),
               middle = nose - model.half_length;
  if (middle < model.half_length) return std::nullopt;
  const Vec2 a = station_at(lane.points, middle - 0.6 * model.half_length).point,
             b = station_at(lane.points, middle + 0.6 * model.half_length).point;
  const Vec2 along = (b - a).normalized();
  const double right = std::max(0.0, lane.width_m / 2 + parking - model.half_width - kerb_gap_m);
  const PlacedModel bus{&model, (a + b) / 2 - left_of(along) * right, 0, std::atan2(along.y(), along.x()), 1};
  for (const Vec2& corner : bus.footprint()) {
    const Station there = station_at(lane.points, nearest_station(lane.points, corner));
    const double left = cross(there.direction, corner - there.point);
    if (left > lane.width_m / 2 || left < -lane.width_m / 2 - parking)
      return std::nullopt;  // the street bends
  }
  return BusAtStop{bus, {nose - 2 * model.half_length - slack_m, nose + slack_m}};
}

class LaneFiller {
 public:
  LaneFiller(const DrivingLane& lane, double from_m, double to_m, std::optional<BusAtStop> bus,
             Traffic& traffic, std::vector<OccupiedStretch>& occupied)
      : lane(lane), from(from_m), front(to_m), bus(std::move(bus)), traffic(traffic), occupied(occupied) {}

  /// Places a vehicle behind `gap` metres of free road, if it fits there. Uses up the road in any case.
  void add(const Model& model, double gap, double sway) {
    constexpr double cycle_half_width_m = 0.5, kerb_gap_m = 0.15;
    if (bus && front - gap - 2 * model.half_length < bus->stretch.to_m + queue_gap_max_m) {
      add_bus();
      gap = std::max(gap, queue_gap_min_m);
    }
    front -= gap;
    const double middle = front - model.half_length, rear = front - 2 * model.half_length;
    front = rear;
    if (rear < from) return;
    // Its axles are on the lane's middle line.
    const Vec2 a = station_at(lane.points, middle - 0.6 * model.half_length).point,
               b = station_at(lane.points, middle + 0.6 * model.half_length).point;
    const Vec2 along = (b - a).normalized();
    const double room = std::max(0.0, lane.width_m / 2 - model.half_width - 0.02);
    const double left = model.half_width < cycle_half_width_m
                            ? -room + kerb_gap_m  // cyclists keep to the right
                            : sway * std::min(room, 0.25);
    const PlacedModel vehicle{&model, (a + b) / 2 + left_of(along) * left, 0,
                              std::atan2(along.y(), along.x()), 1};
    for (const Vec2& corner : vehicle.footprint())
      if (distance_to_line(lane.points, corner) > lane.width_m / 2 + 0.02) return;  // the lane bends
    stand(vehicle, {rear - slack_m, rear + 2 * model.half_length + slack_m});
  }

  bool is_full() const { return front < from; }

  /// Places the bus at the stop, unless it has been placed.
  void add_bus() {
    if (!bus) return;
    traffic.at_stops.push_back(traffic.vehicles.size());
    stand(bus->bus, bus->stretch);
    front = std::min(front, bus->stretch.from_m);
    bus.reset();
  }

 private:
  void stand(const PlacedModel& vehicle, const OccupiedStretch& stretch) {
    traffic.vehicles.push_back(vehicle);
    occupied.insert(occupied.begin(), stretch);
  }

  const DrivingLane& lane;
  double from, front;  ///< the free stretch
  std::optional<BusAtStop> bus;
  Traffic& traffic;
  std::vector<OccupiedStretch>& occupied;
};

/// Adds cyclists along the carriageway's cycle tracks, in the direction of the traffic beside them.
void add_cyclists_on_tracks(const StreetNetwork& network, const ModelLibrary& models,
                            const CityOptions& options, Traffic& traffic) {
  constexpr double before_junction_m = 8, kerb_room_m = 0.1;
  const Stream stream = moving_stream(options, "cyclists on tracks");
  for (std::size_t s = 0; s < network.segments.size(); ++s) {
    const Segment& segment = network.segments[s];
    if (segment.street < 0) continue;
    const StreetProfile& p = network.streets[segment.street].profile;
    for (const bool left : {true, false}) {
      const double width = left ? p.cycle_left_m : p.cycle_right_m;
      if (width == 0) continue;
      Draws draws{substream(stream, 2 * s + left)};
      const double outer = p.half_width() - (left ? p.parking_left_m : p.parking_right_m);
      const double spacing = draws.uniform(35, 120) / std::max(0.05, options.traffic);
      const double end = length(segment.centre) - segment.cut_to - before_junction_m;
      for (double at = segment.cut_from + before_junction_m + spacing * draws.uniform(0, 1); at < end;
           at += spacing * draws.uniform(0.4, 1.6)) {
        const Model& model = draws.one_of(models.cyclists);
        const double room = width / 2 - model.half_width - kerb_room_m;
        const Station there = station_at(segment.centre, at);
        const Vec2 outwards = left_of(there.direction) * (left ? 1.0 : -1.0);
        const Vec2 ahead = left ? Vec2(-there.direction) : there.direction;
        traffic.on_tracks.push_back(
            {&model, there.point + outwards * (outer - width / 2 + draws.uniform(-room, room)), 0,
             std::atan2(ahead.y(), ahead.x()), 1});
      }
    }
  }
}

}  // namespace

Traffic draw_traffic(const StreetNetwork& network, const std::vector<DrivingLane>& lanes,
                     const Districts& districts, const ModelLibrary& models, const CityOptions& options) {
  Traffic traffic;
  traffic.occupied.resize(lanes.size());
  const Stream stream = moving_stream(options, "traffic"), buses = moving_stream(options, "buses at stops");
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const DrivingLane& lane = lanes[i];
    if (lane.segment < 0) continue;
    Draws draws{substream(stream, i)};
    const CityStyle style = districts.style_at(station_at(lane.points, length(lane.points) / 2).point);
    const TrafficDensity dense = density(style);
    const Approach start = approach(network, lane.segment, lane.backward, options.seed),
                   end = approach(network, lane.segment, !lane.backward, options.seed);
    const double from =
        start.crossing ? start.crossing_from_m + start.crossing_length_m + behind_crossing_m : 1.0;
    const double to = end.stop_line  ? end.stop_line_at_m + stop_line_width_m
                      : end.crossing ? end.crossing_from_m + end.crossing_length_m + before_crossing_m
                                     : 1.0;  // before the end
    LaneFiller filler(lane, from, length(lane.points) - to,
                      draw_bus_at_stop(network, lane, models, options, {substream(buses, i)}), traffic,
                      traffic.occupied[i]);
    if (draws.chance(std::min(1.0, dense.lane_share * options.traffic))) {
      const StreetProfile& profile = network.streets[lane.street].profile;
      const bool has_track = (lane.backward ? profile.cycle_left_m : profile.cycle_right_m) > 0;
      const auto add = [&](double gap) {
        const Model& model = draw_vehicle(draws, models, style, has_track);
        filler.add(model, gap, draws.uniform(-1, 1));
      };
      double gap = draws.uniform(before_stop_line_min_m, before_stop_line_max_m);
      const Signal signal = signal_at(network, lane.segment, !lane.backward, options);
      const double waits = signal == Signal::red ? 0.8 : signal == Signal::green ? 0.0 : dense.queue_share;
      if (end.stop_line && draws.chance(waits)) {
        for (int left = draws.integer(1, signal == Signal::red ? 5 : 2); left > 0; --left) {
          add(gap);
          gap = draws.uniform(queue_gap_min_m, queue_gap_max_m);
        }
        gap = draw_headway(draws, dense.headway_m);
      } else {
        gap = draws.uniform(3, dense.headway_m);
      }
      while (!filler.is_full()) {
        add(gap);
        gap = draw_headway(draws, dense.headway_m);
      }
    }
    filler.add_bus();
  }
  add_cyclists_on_tracks(network, models, options, traffic);
  return traffic;
}

}  // namespace cps::city
