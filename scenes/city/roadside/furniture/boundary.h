#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Length of a piece of fence, wall or hedge; boundaries are filled with slightly scaled pieces.
inline constexpr double boundary_module_m = 2.0;

/// Pieces along x, centred at the origin, foot on the ground.
Mesh picket_fence(const Materials& materials);
Mesh mesh_fence(const Materials& materials);
Mesh low_wall(const Materials& materials);
Mesh high_wall(const Materials& materials);

}  // namespace cps::city
