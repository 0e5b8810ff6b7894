#pragma once

#include "scenes/city/materials/materials.h"

/// Parts shared by several kinds of vehicles: x forward, y up, z to the right, metres.
namespace cps::city {

/// Adds a box on each side; `low` and `high` are the corners of the right one.
void add_blocks(Surface& surface, const Vec3& low, const Vec3& high);

/// Adds a tyre with its rim. `hub` is the middle of its outer face; `side` is 1 on the right, −1 on the left.
void add_truck_wheel(Mesh& mesh, const Materials& materials, const Vec3& hub, double radius_m, double width_m,
                     double side);

/// Adds a torus around the z axis, such as a bicycle tyre.
void add_hoop(Surface& surface, const Vec3& middle, double radius_m, double tube_radius_m, int steps,
              int sides);

}  // namespace cps::city
