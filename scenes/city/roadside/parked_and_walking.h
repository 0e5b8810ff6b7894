#pragma once

#include "scenes/city/roadside/kerb_side.h"
#include "scenes/city/roadside/standing_room.h"

/// What stands along the streets today and elsewhere on another day (`CityOptions::traffic_seed`).
namespace cps::city {

/// The ground that a car on `spot` may take, whichever it is.
Polygon car_ground(const Spot& spot);

/// Parked cars along the kerbs, on driveways and in yards, people on the pavements, except on what is kept
/// free, and cyclists on the tracks there.
void add_parked_cars_and_people(StandingRoom& room, const StreetNetwork& network,
                                const std::vector<KerbSide>& kerbs, int block, const ModelLibrary& models,
                                const CityOptions& options);

}  // namespace cps::city
