#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/geometry/footprint.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// Dormers in the front slope, which rises by `slope` from `start` metres behind the eaves line at `foot`
/// height.
void add_dormers(Mesh& mesh, const Footprint& f, double foot, double slope, double start, const Materials& m,
                 Draws& draws);

/// A window in the middle of the gable at one end, which rises `rise` metres above the eaves.
void add_gable_window(Mesh& mesh, const Footprint& f, bool at_end, double eaves, double rise,
                      const Materials& m);

}  // namespace cps::city
