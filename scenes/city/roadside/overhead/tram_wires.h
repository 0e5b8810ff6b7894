#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// Height of the wire that trams take their current from, above the rails.
inline constexpr double contact_wire_m = 5.55;

/// The wires over a street's tram tracks: from mast to mast across the street, and, hung from those, the
/// contact wire of each track, which goes on over junctions. Empty where no tram runs.
Mesh tram_wires(const StreetNetwork& network, int street, const Materials& materials,
                const CityOptions& options);

}  // namespace cps::city
