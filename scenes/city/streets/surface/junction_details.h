#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/driving_lanes.h"

namespace cps::city {

/// What lies on a junction's asphalt: guide lines for those who turn left from lanes of their own, the edge
/// lines of the street that runs through, cycle tracks led across, cracks, patches and manholes.
Mesh junction_details(const StreetNetwork& network, int junction, const std::vector<DrivingLane>& lanes,
                      const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
