#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

/// What years do to asphalt: patches, tarred cracks, and the manholes that were always there. Geometry a few
/// millimetres above it.
namespace cps::city {

/// Along a carriageway; `wear` is about 1.
void add_wear(Mesh& mesh, const Polyline& centre, const StreetProfile& profile, const Materials& materials,
              double wear, Draws& draws);

/// Over a junction's border, but not within `free_of_m` of its middle.
void add_junction_wear(Mesh& mesh, const Polygon& border, const Vec2& middle, double free_of_m,
                       const Materials& materials, double wear, Draws& draws);

}  // namespace cps::city
