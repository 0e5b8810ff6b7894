#pragma once

#include "scenes/city/streets/street_network.h"

namespace cps::city {

/// A drivable lane: its centre line in driving direction, from junction to junction or through one.
struct DrivingLane {
  int street = 0;  ///< through a junction: the street it comes from
  double width_m = 0;
  Polyline points;
  std::vector<int> next;                     ///< lanes that begin where it ends
  int junction = -1;                         ///< the one it crosses; −1: it runs between two
  int segment = -1;                          ///< of the network; −1 through a junction
  bool backward = false;                     ///< it runs against its segment
  double left_kerb_m = 0, right_kerb_m = 0;  ///< from its middle, outside junctions
};

/// All lanes: those of each segment, then the ways through each junction. Right turns leave from the lane at
/// the kerb, left turns from the innermost, into any lane of the other street; no lane ends blind and none is
/// without a way in.
std::vector<DrivingLane> driving_lanes(const StreetNetwork& network);

}  // namespace cps::city
