#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Adds a sign plate, a regular polygon with front and back that faces the traffic (−z in glTF's frame),
/// `forward` metres before its pole, centred at height `height`. `turn` is the angle of the first corner,
/// radians.
void add_plate(Mesh& mesh, MaterialId front, MaterialId back, int corners, double radius, double height,
               double turn, double forward);

}  // namespace cps::city
