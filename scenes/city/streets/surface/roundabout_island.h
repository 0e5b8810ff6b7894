#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The island: a kerb, a paved ring, grass that rises to the middle.
Mesh island(const Roundabout& roundabout, const Vec2& middle, const Materials& materials);

}  // namespace cps::city
