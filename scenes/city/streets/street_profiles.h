#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The layout of a style's streets.
struct StreetPattern {
  double spacing_min_m, spacing_max_m;  ///< between neighbouring streets: range of a city's average
  double min_gap_m;                     ///< between the centre lines of two neighbours
  int min_blocks;                       ///< across the city, however small
  double straight_share;                ///< probability of a city without bends
};

StreetPattern street_pattern(CityStyle style);

/// A street's cross-section in a city of that style. `ring`: the street encloses the city.
StreetProfile draw_street_profile(Draws& draws, CityStyle style, bool ring);

}  // namespace cps::city
