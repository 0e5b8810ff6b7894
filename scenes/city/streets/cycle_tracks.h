#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The cycle tracks of one street: lines, bicycles, in some streets a red surface.
Mesh cycle_tracks(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
