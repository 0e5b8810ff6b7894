#pragma once

#include "sampler/light_draw.h"

namespace cps {

/// The recipe keys for date, place and weather: calls visit(key, member, help) for each. OptionsT is
/// LightOptions or const LightOptions.
template <typename OptionsT, typename Visitor>
void for_each_light_key(OptionsT& o, Visitor&& visit) {
  visit(
      "latitude_deg", o.latitude_deg,
      "latitude of the scenes, degrees north, -90 to 90; with date and hour it decides where the sun stands");
  visit("longitude_deg", o.longitude_deg,
        "longitude of the scenes, degrees east, -180 to 180; hours are universal time");
  visit("day_min", o.day_min, "first day of the year to draw dates from, 1 (1 January) to 365");
  visit("day_max", o.day_max, "last day of the year to draw dates from, day_min to 365");
  visit("sun_elevation_min_deg", o.sun_elevation_min_deg, "lowest sun, degrees above the horizon, 1 to 90");
  visit("sun_elevation_max_deg", o.sun_elevation_max_deg,
        "highest sun, degrees above the horizon, sun_elevation_min_deg to 90");
  visit("clear_share", o.clear_share, "share of the conditions with a clear sky, 0 to 1");
  visit("hazy_share", o.hazy_share,
        "share of the conditions with a hazy sky, 0 to 1; what clear_share and hazy_share leave is overcast");
  visit("turbidity_min", o.turbidity_min,
        "lowest turbidity (haze of the air) of a clear sky: 2, very clear, to 10");
  visit("turbidity_max", o.turbidity_max, "highest turbidity of a clear sky: turbidity_min to 10");
  visit("hazy_turbidity_min", o.hazy_turbidity_min, "lowest turbidity of a hazy sky: 2 to 10, the haziest");
  visit("hazy_turbidity_max", o.hazy_turbidity_max,
        "highest turbidity of a hazy sky: hazy_turbidity_min to 10");
}

}  // namespace cps
