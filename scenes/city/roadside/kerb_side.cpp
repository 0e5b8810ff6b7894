#include "scenes/city/roadside/kerb_side.h"

#include <cmath>

#include "scenes/city/draws.h"

namespace cps::city {
namespace {

constexpr double bus_bay_m = 15;

std::optional<BusStop> draw_bus_stop(const KerbSide& kerb, Draws draws) {
  const bool has_stop = draws.chance(0.35);
  const double s = kerb.from + draws.uniform(3, 12);
  if (!has_stop || s + bus_bay_m > kerb.to) return std::nullopt;
  return BusStop{s, s - 1, s + bus_bay_m};
}

}  // namespace

Vec2 KerbSide::at(double s, double inset) const {
  const Station station = station_at(centre, s);
  return station.point + left_of(station.direction) * (half_width + inset);
}

double KerbSide::facing(double s) const {
  return angle_of(-left_of(direction(s)));
}

KerbSide kerb_side(const StreetNetwork& network, const Side& side, double pavement_m,
                   const CityOptions& options) {
  const Segment& segment = network.segments[side.segment];
  const StreetProfile& profile = network.profile(side);
  const Approach first = approach(network, side.segment, side.reversed, options.seed),
                 last = approach(network, side.segment, !side.reversed, options.seed);
  KerbSide kerb{.side = side,
                .centre = network.line(side, 0),
                .half_width = segment.half_width,
                .pavement_m = pavement_m,
                .from = 0,
                .to = 0,
                .approach = first,
                .cut_m = side.reversed ? segment.cut_to : segment.cut_from,
                .parking_m = side.reversed ? profile.parking_right_m : profile.parking_left_m,
                .meets_traffic = profile.lanes_backward > 0 || side.reversed,
                .runs_with_traffic = profile.lanes_backward == 0 && !side.reversed,
                .bus_stop = std::nullopt};
  kerb.from = kerb.cut_m + first.clear_m;
  kerb.to = length(kerb.centre) - (side.reversed ? segment.cut_from : segment.cut_to) - last.clear_m;
  if (kerb.meets_traffic && profile.kind != "residential")
    kerb.bus_stop = draw_bus_stop(
        kerb, {substream(make_stream(options.seed, "bus stop"), 2 * side.segment + side.reversed)});
  return kerb;
}

double angle_of(const Vec2& direction) {
  return std::atan2(direction.y(), direction.x());
}

}  // namespace cps::city
