#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// Height of the contact wire, from which trams take current, above the rails.
inline constexpr double contact_wire_m = 5.55;

/// The wires over a street's tram tracks: spans across the street from mast to mast, and the contact wires
/// that hang from them, which continue across junctions. Empty without tram tracks.
Mesh tram_wires(const StreetNetwork& network, int street, const Materials& materials,
                const CityOptions& options);

}  // namespace cps::city
