#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// An island on the carriageway: a kerb around a convex or nearly convex outline (anticlockwise), filled with
/// `cover`.
void add_kerbed_island(Mesh& mesh, const Polygon& outline, MaterialId cover, double tile_m,
                       const Materials& materials);

}  // namespace cps::city
