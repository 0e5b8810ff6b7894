#pragma once

#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// A stretch of the block's border along streets, from corner to corner.
struct Frontage {
  Polyline line;
  bool corner_at_end = false;  ///< the next frontage follows around a corner of the streets
};

/// The frontages of a block whose pavements end at `border`, anticlockwise; the end of the built area is
/// none.
std::vector<Frontage> frontages(const StreetNetwork& network, const Block& block, const Outline& border);

/// A polygon without the repeated points that sharp corners have in outlines.
Polygon without_repeats(const Polygon& polygon);

}  // namespace cps::city
