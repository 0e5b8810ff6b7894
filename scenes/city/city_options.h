#pragma once

#include <cstdint>
#include <string>

#include "scenes/city/city_style.h"

namespace cps {

/// What a procedural city is made from: the same options give the same file, byte for byte.
struct CityOptions {
  std::uint64_t seed = 0;          ///< of streets and houses; 0 is a seed like any other
  std::uint64_t traffic_seed = 0;  ///< of what moves: traffic, parked cars, people. Lanes do not know of it
  CityStyle style = CityStyle::european;
  double extent_m = 400;    ///< side length of the area with streets, metres
  double tree_density = 1;  ///< times the seed's own density; 0: no trees
  double parked_cars = 1;   ///< times the seed's own density; 0: empty kerbs
  double traffic = 1;       ///< times the share of lanes that the style fills with traffic; 0: none

  /// Whether a city can be made from these; if not, `why` (may be null) says what to change.
  bool is_valid(std::string* why) const;
};

}  // namespace cps
