#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// Draws the streets, junctions and blocks of a city with a built area of `options.extent_m`.
StreetNetwork draw_street_network(const CityOptions& options);

}  // namespace cps::city
