#pragma once

#include "scenes/city/buildings/building.h"
#include "scenes/city/streets/terrain.h"

namespace cps::city {

/// How high above the level plan the building stands: as the ground at its highest doorway, so that nobody
/// walks into the earth; without doorways, as the ground in its middle.
double ground_level_m(const Building& building, const BuildingPlan& plan, const Terrain& terrain);

/// What a slope asks for, in the building's own heights (`level_m` above the plan): walls carried down below
/// the lowest ground they stand on, steps before doors and ramps before gates that lie above the ground.
void add_foundation(Building& building, const BuildingPlan& plan, double level_m, const Terrain& terrain,
                    const Materials& materials);

}  // namespace cps::city
