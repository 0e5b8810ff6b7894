#pragma once

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/city_options.h"
#include "scenes/city/roadside/model_library.h"

namespace cps::city {

/// The models along a block's kerbs and on its ground: parked cars, people, trees, lamps, signs, hedges. They
/// keep clear of lanes, buildings and each other.
std::vector<PlacedModel> furnish(const StreetNetwork& network, int block, const BlockPlan& plan,
                                 const ModelLibrary& models, const CityCharacter& character,
                                 const CityOptions& options);

}  // namespace cps::city
