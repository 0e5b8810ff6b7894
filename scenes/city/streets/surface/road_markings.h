#pragma once

#include "scenes/city/materials/materials.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

inline constexpr double stop_line_width_m = 0.5;

/// The markings where an arm joins its junction; distances are metres from the beginning of the arm's own
/// carriageway.
struct Approach {
  bool crossing = false, stop_line = false;
  double crossing_from_m = 0.5, crossing_length_m = 3.5, stop_line_at_m = 5.0;
  /// Up to here nobody parks and the centre line is solid.
  double clear_m = 7;
};

/// The approach at one end of a segment (`at_end`: its last junction); the same on every call.
Approach approach(const StreetNetwork& network, int segment, bool at_end, std::uint64_t seed);

/// Lane, centre and edge lines, parking bays, stop lines and zebra crossings of one street.
Mesh road_markings(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed);

}  // namespace cps::city
