#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// Heights above the carriageway, metres. What lies on the asphalt is real geometry, a few millimetres apart.
inline constexpr double kerb_height_m = 0.12, patch_height_m = 0.002, seam_height_m = 0.0035,
                        gutter_height_m = 0.003, paint_height_m = 0.006;
inline constexpr double kerb_width_m = 0.15;

/// The asphalt of a street between its junctions, with wheel tracks, patches, tarred cracks and manholes.
Mesh carriageway(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

/// The asphalt of a junction, out to where the streets' own carriageways begin.
Mesh junction_floor(const StreetNetwork& network, int junction, const Materials& materials,
                    std::uint64_t seed);

/// Kerbs, gutters and pavements around a block: `pavement_m` per side, measured from the carriageway's edge.
Mesh pavement(const StreetNetwork& network, const Block& block, const std::vector<double>& pavement_m,
              const Materials& materials);

}  // namespace cps::city
