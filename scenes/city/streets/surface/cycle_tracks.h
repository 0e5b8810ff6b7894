#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The cycle tracks of one street: lines, bicycles, in some streets a red surface.
Mesh cycle_tracks(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

/// A bicycle on the road, as whoever rides along `ahead` reads it: 1.1 m wide, twice as long as it is wide,
/// for it is seen at a slant.
void paint_bicycle(Surface& paint, const Vec2& at, const Vec2& ahead, double height_m);

}  // namespace cps::city
