#pragma once

#include "scenes/city/roadside/model_library.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The country around the built area, out to hills on the horizon, so that no view ends in the void.
struct Surroundings {
  Mesh terrain;
  std::vector<PlacedModel> models;  ///< houses and trees beyond the rim
};

Surroundings surroundings(const StreetNetwork& network, const Materials& materials,
                          const ModelLibrary& models, const CityOptions& options);

}  // namespace cps::city
