#pragma once

#include <optional>

#include "scenes/city/streets/street_network.h"
#include "scenes/city/streets/surface/road_markings.h"

namespace cps::city {

/// Where buses stop along a kerb, by its stations.
struct BusStop {
  double sign_m = 0;                    ///< where a bus's nose comes to stand
  double bay_from_m = 0, bay_to_m = 0;  ///< where nobody parks
};

/// The kerb of a segment as seen from the block on its left: stations run along the segment's centre line in
/// the side's direction, `inset` leads into the block.
struct KerbSide {
  Side side;
  Polyline centre;
  double half_width = 0, pavement_m = 0;
  double from = 0, to = 0;  ///< between the junctions' surroundings, where things may stand
  Approach approach;        ///< of the junction where the side begins
  double cut_m = 0;         ///< up to here the street is that junction's
  double parking_m = 0;
  /// Whether traffic at this kerb comes towards the side's beginning, as it does where it keeps the block on
  /// its right, or runs along with the side: at the left kerb of a one-way street.
  bool meets_traffic = false, runs_with_traffic = false;
  std::optional<BusStop> bus_stop;

  Vec2 at(double s, double inset) const;
  Vec2 direction(double s) const { return station_at(centre, s).direction; }
  /// Heading of something whose +x faces the carriageway.
  double facing(double s) const;
};

KerbSide kerb_side(const StreetNetwork& network, const Side& side, double pavement_m,
                   const CityOptions& options);

/// The angle of a direction of the plan, anticlockwise from east.
double angle_of(const Vec2& direction);

}  // namespace cps::city
