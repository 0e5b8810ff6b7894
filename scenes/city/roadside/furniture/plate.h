#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// A flat polygon facing the traffic (−z in glTF's frame), `forward` metres before its pole, its middle at
/// height `height`, with a back of its own; `turn` is the first corner's angle from the horizontal.
void add_plate(Mesh& mesh, MaterialId front, MaterialId back, int corners, double radius, double height,
               double turn, double forward);

}  // namespace cps::city
