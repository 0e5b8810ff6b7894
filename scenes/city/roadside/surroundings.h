#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/roadside/model_library.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// The country around the built area, out to hills on the horizon.
struct Surroundings {
  Mesh terrain;
  std::vector<PlacedModel> models;  ///< houses and trees outside the built area
};

Surroundings surroundings(const StreetNetwork& network, const Materials& materials,
                          const ModelLibrary& models, const CityOptions& options);

}  // namespace cps::city
