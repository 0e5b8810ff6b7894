#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

inline constexpr double bus_length_m = 12, bus_width_m = 2.55, bus_height_m = 3.2, bus_mirror_m = 0.19;

/// A low-floor city bus, wheels on the ground around the origin, looking along +x, doors on its right;
/// `paint` is its body's.
Mesh bus(const Materials& materials, MaterialId paint);

}  // namespace cps::city
