#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/roadside/kerb_side.h"
#include "scenes/city/roadside/standing_room.h"

/// Parked cars and people, whose places depend on `CityOptions::traffic_seed`.
namespace cps::city {

/// The ground that any car on `spot` may cover.
Polygon car_ground(const Spot& spot);

/// Adds parked cars along the kerbs, on driveways and in yards; people on the pavements, outside ground kept
/// free; and cyclists on the pavements' tracks.
void add_parked_cars_and_people(StandingRoom& room, const StreetNetwork& network,
                                const std::vector<KerbSide>& kerbs, int block, const ModelLibrary& models,
                                const CityOptions& options);

}  // namespace cps::city
