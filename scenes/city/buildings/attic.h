#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/geometry/footprint.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Adds dormers to the front roof slope. The slope begins at height `foot` and rises by `slope` (tangent);
/// the dormers' fronts stand `start` metres behind the front wall.
void add_dormers(Mesh& mesh, const Footprint& f, double foot, double slope, double start, const Materials& m,
                 Draws& draws);

/// Adds a window in the middle of the gable at one end. The gable rises `rise` metres above the eaves.
void add_gable_window(Mesh& mesh, const Footprint& f, bool at_end, double eaves, double rise,
                      const Materials& m);

}  // namespace cps::city
