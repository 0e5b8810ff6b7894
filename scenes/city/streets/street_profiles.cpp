#include "scenes/city/streets/street_profiles.h"

namespace cps::city {
namespace {

StreetProfile residential(Draws& draws) {
  return {"residential", 1, 1, draws.uniform(3.0, 3.3), 2.2, 2.2, draws.uniform(2.4, 3.2), draws.chance(0.4)};
}

StreetProfile collector(Draws& draws) {
  const bool parking = draws.chance(0.7);
  return {"collector", 1, 1, draws.uniform(3.25, 3.75), 0, parking ? 2.3 : 0.0, draws.uniform(2.8, 4.2),
          true};
}

StreetProfile avenue(Draws& draws) {
  return {"avenue", 2, 2, draws.uniform(3.0, 3.4), 2.3, 2.3, draws.uniform(3.8, 5.0), true};
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
    return {"boulevard", 3, 3, lane, parking, parking, pavement, true};
  }
  if (kind < 0.65) {
    const double parking = draws.chance(0.6) ? 2.3 : 0.0;
    return {"avenue", 2, 2, lane, parking, parking, pavement, true};
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
  return {"collector", 1, 1, draws.uniform(3.5, 3.75), 0, parking, draws.uniform(2.2, 3.2), true};
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
