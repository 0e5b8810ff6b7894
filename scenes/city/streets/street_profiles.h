#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// How a style lays out its streets.
struct StreetPattern {
  double spacing_min_m, spacing_max_m;  ///< between neighbouring streets, on average over a city
  double min_gap_m;                     ///< between the centre lines of any two neighbours
  int least_blocks;                     ///< across the city, however small it is
  double straight_share;                ///< of cities without bends
};

StreetPattern street_pattern(CityStyle style);

/// A street's cross-section in a city of that style; `ring`: it encloses the city.
StreetProfile draw_street_profile(Draws& draws, CityStyle style, bool ring);

}  // namespace cps::city
