#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Adds an island on the carriageway: a kerb along a convex or nearly convex outline (anticlockwise), filled
/// with `cover`.
void add_kerbed_island(Mesh& mesh, const Polygon& outline, MaterialId cover, double tile_m,
                       const Materials& materials);

}  // namespace cps::city
