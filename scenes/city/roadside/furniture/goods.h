#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// What stands in the yards of works, foot on the ground, long side along x.
Mesh container(const Materials& materials, MaterialId paint);  ///< ISO 668, twenty feet
Mesh container_stack(const Materials& materials);              ///< two of them
Mesh pallets(const Materials& materials);
Mesh silo(const Materials& materials);

}  // namespace cps::city
