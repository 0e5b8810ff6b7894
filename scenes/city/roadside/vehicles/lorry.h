#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

inline constexpr double lorry_length_m = 7.6, lorry_width_m = 2.5, lorry_height_m = 3.4;

/// A lorry with a box body, centred at the origin, wheels on the ground, facing +x. `paint` is the cab's
/// material.
Mesh lorry(const Materials& materials, MaterialId paint);

}  // namespace cps::city
