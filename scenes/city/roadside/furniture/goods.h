#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Goods in factory yards, foot on the ground, long side along x.
Mesh container(const Materials& materials, MaterialId paint);  ///< twenty-foot container (ISO 668)
Mesh container_stack(const Materials& materials);              ///< two containers
Mesh pallets(const Materials& materials);
Mesh silo(const Materials& materials);

}  // namespace cps::city
