#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The outline of the island between a crossing and the junction, where whoever walks waits half-way; behind
/// the crossing the median itself begins. `at_end`: where the segment ends. Empty without a median or a
/// crossing.
Polygon refuge_nose(const StreetNetwork& network, int segment, bool at_end, std::uint64_t seed);

/// The kerbed strip between a street's two directions, open at junctions and crossings.
Mesh median(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
