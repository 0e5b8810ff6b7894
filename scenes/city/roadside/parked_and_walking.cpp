#include "scenes/city/roadside/parked_and_walking.h"

#include <algorithm>

#include "scenes/city/roadside/pavement_tracks.h"
#include "scenes/city/roadside/vehicles/vehicle.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

void park(StandingRoom& room, const KerbSide& kerb, const ModelLibrary& models, double parked_cars,
          Draws draws) {
  if (kerb.parking_m <= 0) return;
  const double occupied = std::min(1.0, draws.uniform(0.35, 0.9) * parked_cars);
  double s = kerb.from + 0.5;
  while (s < kerb.to) {
    const Model& model = draw_car(draws, models);
    const double gap = draws.uniform(0.10, 0.22), space = draws.uniform(0.5, 1.4),
                 turn = draws.uniform(-0.012, 0.012);
    const double reach =
        2 * model.half_width + 0.06 - mirror_m;  // the mirror on the pavement's side overhangs the kerb
    const bool is_at_stop = kerb.bus_stop && s <= kerb.bus_stop->bay_to_m &&
                            s + 2 * model.half_length >= kerb.bus_stop->bay_from_m;
    const bool parked = draws.chance(occupied) && gap + reach <= kerb.parking_m &&
                        s + 2 * model.half_length < kerb.to && !is_at_stop;
    if (parked) {
      const double middle = s + model.half_length;
      const Vec2 direction = kerb.runs_with_traffic ? kerb.direction(middle) : Vec2(-kerb.direction(middle));
      room.try_place(
          {&model, kerb.at(middle, -gap - (model.half_width - mirror_m)), 0, angle_of(direction) + turn, 1});
    }
    s += 2 * model.half_length + space;
  }
}

/// Adds people along a kerb, more where there are shops and towers.
void walk(StandingRoom& room, const KerbSide& kerb, const ModelLibrary& models, Draws draws) {
  const bool busy = room.plan.kind == BlockKind::closed || room.plan.kind == BlockKind::towers;
  const double spacing = draws.uniform(0.6, 1.8) * (busy ? 16 : 55);
  for (double s = kerb.from + draws.uniform(0, spacing); s < kerb.to;
       s += spacing * draws.uniform(0.3, 1.7)) {
    const double inset = draws.uniform(0.8, std::max(0.9, kerb.pavement_m - 0.6));
    const Vec2 along = draws.chance(0.5) ? kerb.direction(s) : Vec2(-kerb.direction(s));
    room.try_place({&draws.one_of(models.people), kerb.at(s, inset), kerb_height_m,
                    angle_of(along) + draws.uniform(-0.4, 0.4), 1});
  }
}

/// Adds cyclists along a track on the pavement.
void ride(StandingRoom& room, const Polyline& track, double width_m, const ModelLibrary& models,
          double traffic, Draws draws) {
  if (track.empty()) return;
  const double spacing = draws.uniform(35, 120) / std::max(0.05, traffic);
  for (double s = spacing * draws.uniform(0, 1); s < length(track); s += spacing * draws.uniform(0.4, 1.6)) {
    const Model& model = draws.one_of(models.cyclists);
    const double aside = draws.uniform(-0.5, 0.5) * std::max(0.0, width_m - 2 * model.half_width - 0.2);
    const Station at = station_at(track, s);
    if (s > model.half_length && s + model.half_length < length(track))
      room.try_place({&model, at.point + left_of(at.direction) * aside, kerb_height_m + pavement_track_rise_m,
                      angle_of(at.direction), 1});
  }
}

}  // namespace

Polygon car_ground(const Spot& spot) {
  constexpr double half_length_m = 2.7, half_width_m = 1.2;
  const Vec2 a = spot.direction * half_length_m, b = left_of(spot.direction) * half_width_m;
  return {spot.position - a - b, spot.position + a - b, spot.position + a + b, spot.position - a + b};
}

void add_parked_cars_and_people(StandingRoom& room, const StreetNetwork& network,
                                const std::vector<KerbSide>& kerbs, int block, const ModelLibrary& models,
                                const CityOptions& options) {
  const auto draws_of = [&](const char* name, int thing) {
    return Draws{substream(moving_stream(options, name), thing)};
  };
  for (const KerbSide& kerb : kerbs) {
    const int thing = 2 * kerb.side.segment + kerb.side.reversed;
    park(room, kerb, models, options.parked_cars, draws_of("parked at kerbs", thing));
    walk(room, kerb, models, draws_of("walking", thing));
  }
  room.kept_free.clear();
  for (const KerbSide& kerb : kerbs)
    ride(room, pavement_track(network, kerb), network.profile(kerb.side).pavement_cycle_m, models,
         options.traffic, draws_of("riding", 2 * kerb.side.segment + kerb.side.reversed));
  Draws draws = draws_of("parked on spots", block);
  for (const Spot& spot : room.plan.car_spots) {
    const Model& model = draw_car(draws, models);
    if (draws.chance(std::min(1.0, 0.8 * options.parked_cars)))
      room.try_place({&model, spot.position, kerb_height_m + spot.rise_m, angle_of(spot.direction), 1});
  }
}

}  // namespace cps::city
