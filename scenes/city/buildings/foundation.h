#pragma once

#include "scenes/city/buildings/building.h"
#include "scenes/city/streets/terrain.h"

namespace cps::city {

/// The building's height above the level plan: that of the ground at its highest doorway, so that no doorway
/// is buried; without doorways, that of the ground at its middle.
double ground_level_m(const Building& building, const BuildingPlan& plan, const Terrain& terrain);

/// Adds what a slope requires, in the building's own heights (`level_m` above the plan): walls extended below
/// the lowest ground along them, steps before doors and ramps before gates that are above the ground.
void add_foundation(Building& building, const BuildingPlan& plan, double level_m, const Terrain& terrain,
                    const Materials& materials);

}  // namespace cps::city
