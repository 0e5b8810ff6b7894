#pragma once

#include "scenes/scene.h"

namespace cps {

/// Guesses the metres per unit of a street scene that is not in metres: the power of ten nearest to 1 that
/// makes the scene 3 to 60 m high (between the 5th and 95th percentile of its vertices) and 20 m to 20 km
/// wide; if none does both, the one that makes its height right; else 1.
double guess_unit_scale(const Scene& scene);

/// Multiplies all lengths of the scene: instances, lanes, lights, cameras. The lights' intensities grow with
/// the square, so that surfaces are as bright as before.
void scale_scene(Scene& scene, double metres_per_unit);

}  // namespace cps
