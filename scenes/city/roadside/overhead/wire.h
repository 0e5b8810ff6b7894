#pragma once

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// A hanging wire: a tube of three sides along a parabola that hangs `sag_m` through in its middle.
void add_wire(Surface& surface, const Vec3& from, const Vec3& to, double sag_m, double radius_m);

}  // namespace cps::city
