#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The kerbed strip between a street's two directions, open at junctions and crossings.
Mesh median(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
