#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The outline of the refuge island between a pedestrian crossing and the junction, at one end of the segment
/// (`at_end`: its last junction). Empty without a median or a crossing. The median proper begins on the
/// crossing's other side.
Polygon refuge_nose(const StreetNetwork& network, int segment, bool at_end, std::uint64_t seed);

/// The kerbed strip between a street's two directions, with gaps at junctions and crossings.
Mesh median(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
