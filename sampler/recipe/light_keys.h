#pragma once

#include "sampler/light_draw.h"

namespace cps {

/// The list of keys that say where, when and in what weather scenes are seen: visit(key, member, help).
/// OptionsT is LightOptions or const LightOptions.
template <typename OptionsT, typename Visitor>
void for_each_light_key(OptionsT& o, Visitor&& visit) {
  visit("latitude_deg", o.latitude_deg, "where the scenes lie, north positive: it decides the sun's ways");
  visit("longitude_deg", o.longitude_deg, "east positive; hours are universal time");
  visit("day_min", o.day_min, "first day of the year on which they are seen; 1 January is 1");
  visit("day_max", o.day_max, "last day");
  visit("sun_elevation_min_deg", o.sun_elevation_min_deg, "lowest sun, degrees above the horizon");
  visit("sun_elevation_max_deg", o.sun_elevation_max_deg, "highest sun");
  visit("clear_share", o.clear_share, "share of clear days");
  visit("hazy_share", o.hazy_share, "share of hazy days; the rest is overcast");
  visit("turbidity_min", o.turbidity_min, "clearest air of a clear day: 2 very clear");
  visit("turbidity_max", o.turbidity_max, "its haziest");
  visit("hazy_turbidity_min", o.hazy_turbidity_min, "clearest air of a hazy day");
  visit("hazy_turbidity_max", o.hazy_turbidity_max, "its haziest: 6 hazy, 10 the haziest there is");
}

}  // namespace cps
