#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/driving_lanes.h"

namespace cps::city {

/// Markings and wear on a junction's asphalt: guide lines for left turns of multi-lane streets, edge lines
/// and cycle tracks of the street that runs through, cracks, patches and manholes.
Mesh junction_details(const StreetNetwork& network, int junction, const std::vector<DrivingLane>& lanes,
                      const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
