#pragma once

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// Adds a hanging wire: a three-sided tube along a parabola with a sag of `sag_m` in its middle.
void add_wire(Surface& surface, const Vec3& from, const Vec3& to, double sag_m, double radius_m);

}  // namespace cps::city
