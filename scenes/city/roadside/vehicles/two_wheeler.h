#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Half sizes of a bicycle or motorcycle with its rider.
inline constexpr double bicycle_half_length_m = 0.9, bicycle_half_width_m = 0.33;
inline constexpr double motorcycle_half_length_m = 1.1, motorcycle_half_width_m = 0.42;

/// A bicycle centred at the origin, tyres on the ground, facing +x.
Mesh bicycle(const Materials& materials, Stream stream);
/// The bicycle with its rider.
Mesh cyclist(const Materials& materials, Stream stream);
/// A motorcycle with its rider.
Mesh motorcyclist(const Materials& materials, Stream stream);

}  // namespace cps::city
