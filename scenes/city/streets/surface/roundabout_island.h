#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The island of a roundabout: a kerb, a paved ring, and grass that rises towards the middle.
Mesh island(const Roundabout& roundabout, const Vec2& middle, const Materials& materials);

}  // namespace cps::city
