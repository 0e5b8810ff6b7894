#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// A grown person on foot, walking or standing, around the origin, looking along +x.
Mesh person(const Materials& materials, Stream stream);

}  // namespace cps::city
