#pragma once

#include "scenes/scene.h"

namespace cps {

/// Metres per unit, guessed for a street scene whose file does not keep to metres: the power of ten, nearest
/// 1, that makes most of the scene as high as streets are (3 to 60 m between the lowest and the highest
/// twentieth of its vertices) and 20 m to 20 km wide; where none does both, the one that makes its height
/// right.
double guess_unit_scale(const Scene& scene);

/// Multiplies all lengths: instances, lanes, lamps (as bright from the place scaled with them), cameras.
void scale_scene(Scene& scene, double metres_per_unit);

}  // namespace cps
