#pragma once

#include <cstdint>
#include <string>

#include "scenes/city/city_style.h"

namespace cps {

/// Options of a procedural city. The same options give the same file, byte for byte.
struct CityOptions {
  std::uint64_t seed = 0;          ///< of streets, houses and everything else that does not move
  std::uint64_t traffic_seed = 0;  ///< of what moves: traffic, parked cars, people. Does not change lanes
  CityStyle style = CityStyle::european;
  double extent_m = 400;    ///< side length of the area with streets, metres
  double tree_density = 1;  ///< factor on the density drawn from the seed; 0: no trees
  double parked_cars = 1;   ///< factor on the density drawn from the seed; 0: none
  double traffic = 1;       ///< factor on the style's share of lanes with traffic; 0: none

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

}  // namespace cps
