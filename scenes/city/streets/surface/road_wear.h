#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

/// Wear of the asphalt: patches, tarred cracks and manholes, as geometry a few millimetres above it.
namespace cps::city {

/// Adds wear along a carriageway; `wear` scales its amount and is about 1.
void add_wear(Mesh& mesh, const Polyline& centre, const StreetProfile& profile, const Materials& materials,
              double wear, Draws& draws);

/// Adds wear inside a junction's border, but not within `clear_radius_m` of its middle.
void add_junction_wear(Mesh& mesh, const Polygon& border, const Vec2& middle, double clear_radius_m,
                       const Materials& materials, double wear, Draws& draws);

}  // namespace cps::city
