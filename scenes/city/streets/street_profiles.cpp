#include "scenes/city/streets/street_profiles.h"

namespace cps::city {
namespace {

/// Replaces the parking bays by cycle tracks.
void lay_cycle_tracks(StreetProfile& p, double width_m) {
  p.parking_left_m = p.parking_right_m = 0;
  p.cycle_right_m = width_m;
  if (p.lanes_backward > 0) p.cycle_left_m = width_m;
}

/// Adds a median, tram tracks or cycle tracks, with the given probabilities.
void draw_extras(StreetProfile& p, double median, double tram, double cycle, Draws& draws) {
  const double pick = draws.uniform(0, 1), cycle_m = draws.uniform(1.5, 1.85),
               median_m = draws.uniform(1.6, 2.6);
  if (draws.chance(cycle)) lay_cycle_tracks(p, cycle_m);
  if (pick < median)
    p.median_m = median_m;
  else
    p.tram_tracks = pick < median + tram;
  constexpr double min_pavement_m = 4.0;
  const double width_m = draws.uniform(1.4, 1.6);
  if (p.cycle_right_m == 0 && p.pavement_m >= min_pavement_m && draws.chance(0.5))
    p.pavement_cycle_m = width_m;
}

StreetProfile residential(Draws& draws) {
  return {"residential", 1, 1, draws.uniform(3.0, 3.3), 2.2, 2.2, draws.uniform(2.4, 3.2), draws.chance(0.4)};
}

StreetProfile collector(Draws& draws) {
  const bool parking = draws.chance(0.7);
  StreetProfile p{
      "collector", 1, 1, draws.uniform(3.25, 3.75), 0, parking ? 2.3 : 0.0, draws.uniform(2.8, 4.2), true};
  draw_extras(p, 0, 0, 0.35, draws);
  return p;
}

StreetProfile avenue(Draws& draws) {
  StreetProfile p{"avenue", 2, 2, draws.uniform(3.0, 3.4), 2.3, 2.3, draws.uniform(3.8, 5.0), true};
  draw_extras(p, 0.15, 0.4, 0.45, draws);
  return p;
}

StreetProfile one_way(Draws& draws) {
  return {"one-way", 1, 0, draws.uniform(3.4, 3.75), 2.1, 2.1, draws.uniform(2.2, 3.0), false};
}

StreetProfile european(Draws& draws, bool ring) {
  const double kind = ring ? draws.uniform(0.4, 0.75) : draws.uniform(0, 1);
  return kind < 0.42   ? residential(draws)
         : kind < 0.75 ? collector(draws)
         : kind < 0.88 ? avenue(draws)
                       : one_way(draws);
}

StreetProfile downtown(Draws& draws, bool ring) {
  const double kind = ring ? 0.6 : draws.uniform(0, 1);
  const double lane = draws.uniform(3.0, 3.5), pavement = draws.uniform(4.0, 6.0);
  if (kind < 0.3) {
    const double parking = draws.chance(0.4) ? 2.3 : 0.0;
    StreetProfile p{"boulevard", 3, 3, lane, parking, parking, pavement, true};
    draw_extras(p, 0.45, 0.3, 0.4, draws);
    return p;
  }
  if (kind < 0.65) {
    const double parking = draws.chance(0.6) ? 2.3 : 0.0;
    StreetProfile p{"avenue", 2, 2, lane, parking, parking, pavement, true};
    draw_extras(p, 0.25, 0.3, 0.35, draws);
    return p;
  }
  if (kind < 0.85) return {"one-way", draws.integer(2, 3), 0, lane, 2.3, 2.3, pavement, false};
  return {"collector", 1, 1, draws.uniform(3.25, 3.75), 2.3, 2.3, pavement, true};
}

StreetProfile suburb(Draws& draws, bool ring) {
  const double kind = ring ? 0.9 : draws.uniform(0, 1);
  if (kind < 0.8) {
    const bool parking = draws.chance(0.5);
    return {"residential",           1,    1, draws.uniform(3.0, 3.4), 0, parking ? 2.1 : 0.0,
            draws.uniform(2.2, 3.0), false};
  }
  return collector(draws);
}

StreetProfile industrial(Draws& draws, bool ring) {
  const double kind = ring ? 0.5 : draws.uniform(0, 1);
  if (kind < 0.25) return {"avenue", 2, 2, draws.uniform(3.4, 3.75), 0, 0, draws.uniform(2.4, 3.4), true};
  const double parking = draws.chance(0.4) ? 2.3 : 0.0;
  StreetProfile p{"collector", 1, 1, draws.uniform(3.5, 3.75), 0, parking, draws.uniform(2.2, 3.2), true};
  draw_extras(p, 0, 0, 0.2, draws);
  return p;
}

}  // namespace

StreetPattern street_pattern(CityStyle style) {
  switch (style) {
    case CityStyle::european:
      return {60, 76, 44, 5, 0.4};
    case CityStyle::downtown:
      return {76, 104, 62, 4, 0.8};
    case CityStyle::suburb:
      return {62, 84, 50, 4, 0.2};
    case CityStyle::industrial:
      return {100, 140, 74, 3, 0.6};
    case CityStyle::mixed:
      return {68, 92, 54, 4, 0.4};
  }
  return {};
}

StreetProfile draw_street_profile(Draws& draws, CityStyle style, bool ring) {
  if (style == CityStyle::mixed) style = static_cast<CityStyle>(draws.integer(0, 3));
  switch (style) {
    case CityStyle::downtown:
      return downtown(draws, ring);
    case CityStyle::suburb:
      return suburb(draws, ring);
    case CityStyle::industrial:
      return industrial(draws, ring);
    case CityStyle::european:
    case CityStyle::mixed:
      break;
  }
  return european(draws, ring);
}

}  // namespace cps::city
