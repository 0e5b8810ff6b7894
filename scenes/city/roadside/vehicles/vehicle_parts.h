#pragma once

#include "scenes/city/materials/materials.h"

/// Pieces that vehicles of several kinds are put together from: x forward, y up, z to the right, metres.
namespace cps::city {

/// Boxes on both sides: `low` and `high` are the corners of the right one.
void add_blocks(Surface& surface, const Vec3& low, const Vec3& high);

/// A tyre with its rim; `hub` is the middle of its outer face, `side` +1 on the right and −1 on the left.
void add_truck_wheel(Mesh& mesh, const Materials& materials, const Vec3& hub, double radius_m, double width_m,
                     double side);

/// A closed ring of tube around z, as a bicycle's tyre is.
void add_hoop(Surface& surface, const Vec3& middle, double radius_m, double tube_radius_m, int steps,
              int sides);

}  // namespace cps::city
