#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The asphalt of a street between its junctions, darker along the wheel tracks, with patches, tarred cracks
/// and manholes.
Mesh carriageway(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

/// The asphalt of a junction, up to the streets' own carriageways.
Mesh junction_floor(const StreetNetwork& network, int junction, const Materials& materials,
                    std::uint64_t seed);

/// Kerbs, gutters and pavements around a block. `pavement_m`: per side, the pavement's width from the
/// carriageway's edge.
Mesh pavement(const StreetNetwork& network, const Block& block, const std::vector<double>& pavement_m,
              const Materials& materials);

}  // namespace cps::city
