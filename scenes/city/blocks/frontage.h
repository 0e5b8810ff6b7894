#pragma once

#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// A stretch of a block's border along streets, from corner to corner.
struct Frontage {
  Polyline line;
  bool corner_at_end = false;  ///< the next frontage begins around a street corner
};

/// The frontages of a block along `border`, the inner edge of its pavements, anticlockwise. Excludes the
/// border of the built area.
std::vector<Frontage> frontages(const StreetNetwork& network, const Block& block, const Outline& border);

/// The polygon without repeated points, which outlines have at sharp corners.
Polygon without_repeats(const Polygon& polygon);

}  // namespace cps::city
