#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// An adult, walking or standing, at the origin, facing +x.
Mesh person(const Materials& materials, Stream stream);

}  // namespace cps::city
