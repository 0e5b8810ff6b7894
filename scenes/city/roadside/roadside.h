#pragma once

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/roadside/model_library.h"

namespace cps::city {

/// What stands along a block's kerbs and grows on its ground: parked cars, trees, lamps, signs, hedges.
/// Everything keeps clear of lanes, houses and each other.
std::vector<PlacedModel> furnish(const StreetNetwork& network, int block, const BlockPlan& plan,
                                 const ModelLibrary& models, const CityCharacter& character,
                                 const CityOptions& options);

}  // namespace cps::city
