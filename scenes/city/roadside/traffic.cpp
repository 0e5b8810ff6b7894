#include "scenes/city/roadside/traffic.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/roadside/signals.h"

namespace cps::city {
namespace {

/// Free road from bumper to bumper: in a queue, and between vehicles on their way.
constexpr double queue_gap_min_m = 1.2, queue_gap_max_m = 2.8, headway_min_m = 15, headway_max_m = 60;
constexpr double before_stop_line_min_m = 0.3, before_stop_line_max_m = 1.2, behind_crossing_m = 1,
                 before_crossing_m = 1;

/// How a style's lanes are filled.
struct TrafficDensity {
  double lane_share;   ///< of lanes with traffic
  double queue_share;  ///< of those that end at a stop line without a light: with somebody waiting there
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

/// Between the shortest and the longest headway, short ones more often, `mean` on average.
double draw_headway(Draws& draws, double mean) {
  const double t = (mean - headway_min_m) / (headway_max_m - headway_min_m);
  return std::lerp(headway_min_m, headway_max_m, std::pow(draws.uniform(0, 1), 1 / t - 1));
}

const Model& draw_vehicle(Draws& draws, const ModelLibrary& models, CityStyle style) {
  const bool works = style == CityStyle::industrial, centre = style == CityStyle::downtown;
  const double pick = draws.uniform(0, 1), lorries = works ? 0.2 : 0.05, buses = centre ? 0.08 : 0.05;
  if (pick < lorries) return draws.one_of(models.lorries);
  if (pick < lorries + buses) return draws.one_of(models.buses);
  if (pick < lorries + buses + 0.04) return draws.one_of(models.motorcyclists);
  if (pick < lorries + buses + 0.12) return draws.one_of(models.cyclists);
  return draw_car(draws, models);
}

class LaneFiller {
 public:
  LaneFiller(const DrivingLane& lane, double from_m, double to_m) : lane(lane), from(from_m), front(to_m) {}

  /// Puts a vehicle behind `gap` metres of free road, if the lane has room for it there. The road is used up
  /// either way.
  void add(const Model& model, double gap, double sway, Traffic& traffic, std::size_t index) {
    constexpr double cycle_half_width_m = 0.5, kerb_gap_m = 0.15;
    front -= gap;
    const double middle = front - model.half_length, rear = front - 2 * model.half_length;
    front = rear;
    if (rear < from) return;
    // On two points of the lane, as its axles are.
    const Vec2 a = station_at(lane.points, middle - 0.6 * model.half_length).point,
               b = station_at(lane.points, middle + 0.6 * model.half_length).point;
    const Vec2 along = (b - a).normalized();
    const double room = std::max(0.0, lane.width_m / 2 - model.half_width - 0.02);
    const double left = model.half_width < cycle_half_width_m ? -room + kerb_gap_m  // keeps to the right
                                                              : sway * std::min(room, 0.25);
    const PlacedModel vehicle{&model, (a + b) / 2 + left_of(along) * left, 0,
                              std::atan2(along.y(), along.x()), 1};
    for (const Vec2& corner : vehicle.footprint())
      if (distance_to_line(lane.points, corner) > lane.width_m / 2 + 0.02) return;  // the lane bends
    traffic.vehicles.push_back(vehicle);
    constexpr double slack_m = 0.1;  // a chord is shorter than its arc
    auto& occupied = traffic.occupied[index];
    occupied.insert(occupied.begin(), {rear - slack_m, rear + 2 * model.half_length + slack_m});
  }

  bool is_full() const { return front < from; }

 private:
  const DrivingLane& lane;
  double from, front;  ///< what is free
};

}  // namespace

Traffic draw_traffic(const StreetNetwork& network, const std::vector<DrivingLane>& lanes,
                     const Districts& districts, const ModelLibrary& models, const CityOptions& options) {
  Traffic traffic;
  traffic.occupied.resize(lanes.size());
  const Stream stream = moving_stream(options, "traffic");
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const DrivingLane& lane = lanes[i];
    if (lane.segment < 0) continue;
    Draws draws{substream(stream, i)};
    const CityStyle style = districts.style_at(station_at(lane.points, length(lane.points) / 2).point);
    const TrafficDensity dense = density(style);
    if (!draws.chance(std::min(1.0, dense.lane_share * options.traffic))) continue;
    const Approach start = approach(network, lane.segment, lane.backward, options.seed),
                   end = approach(network, lane.segment, !lane.backward, options.seed);
    const double from =
        start.crossing ? start.crossing_from_m + start.crossing_length_m + behind_crossing_m : 1.0;
    const double to = end.stop_line  ? end.stop_line_at_m + stop_line_width_m
                      : end.crossing ? end.crossing_from_m + end.crossing_length_m + before_crossing_m
                                     : 1.0;  // before the end
    LaneFiller filler(lane, from, length(lane.points) - to);
    double gap = draws.uniform(before_stop_line_min_m, before_stop_line_max_m);
    const Signal signal = signal_at(network, lane.segment, !lane.backward, options);
    const double waits = signal == Signal::red ? 0.8 : signal == Signal::green ? 0.0 : dense.queue_share;
    if (end.stop_line && draws.chance(waits)) {
      for (int left = draws.integer(1, signal == Signal::red ? 5 : 2); left > 0; --left) {
        filler.add(draw_vehicle(draws, models, style), gap, draws.uniform(-1, 1), traffic, i);
        gap = draws.uniform(queue_gap_min_m, queue_gap_max_m);
      }
      gap = draw_headway(draws, dense.headway_m);
    } else {
      gap = draws.uniform(3, dense.headway_m);
    }
    while (!filler.is_full()) {
      filler.add(draw_vehicle(draws, models, style), gap, draws.uniform(-1, 1), traffic, i);
      gap = draw_headway(draws, dense.headway_m);
    }
  }
  return traffic;
}

}  // namespace cps::city
