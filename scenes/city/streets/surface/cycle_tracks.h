#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The markings of one street's cycle tracks: lines, bicycle symbols, in some streets a red surface.
Mesh cycle_tracks(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

/// Paints a bicycle symbol, upright for a rider who comes along `ahead` (unit): 1.1 m wide and stretched to
/// twice that length, because it is seen at a flat angle.
void paint_bicycle(Surface& paint, const Vec2& at, const Vec2& ahead, double height_m);

}  // namespace cps::city
