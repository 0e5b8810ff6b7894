#pragma once

#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// A drivable lane, by its centre line in driving direction: along a segment or across a junction.
struct DrivingLane {
  int street = 0;  ///< across a junction: the street it comes from
  double width_m = 0;
  Polyline points;
  std::vector<int> next;                     ///< lanes that begin where it ends
  int junction = -1;                         ///< the junction it crosses; −1: it runs along a segment
  int segment = -1;                          ///< the segment it runs along; −1: it crosses a junction
  bool backward = false;                     ///< it runs against its segment's direction
  double left_kerb_m = 0, right_kerb_m = 0;  ///< distance from its middle; along segments only
};

/// All lanes: first those along segments, then those across junctions. Right turns leave from the lane at the
/// kerb, left turns from the innermost lane, into any lane of the other street. Every lane has a successor
/// and a predecessor.
std::vector<DrivingLane> driving_lanes(const StreetNetwork& network);

}  // namespace cps::city
