#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

inline constexpr double bus_length_m = 12, bus_width_m = 2.55, bus_height_m = 3.2, bus_mirror_m = 0.19;

/// A low-floor city bus, centred at the origin, wheels on the ground, facing +x, doors on its right. `paint`
/// is the body's material.
Mesh bus(const Materials& materials, MaterialId paint);

}  // namespace cps::city
