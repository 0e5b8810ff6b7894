#pragma once

#include <optional>

#include "scenes/city/city_options.h"
#include "scenes/city/streets/street_network.h"
#include "scenes/city/streets/surface/road_markings.h"

namespace cps::city {

/// A bus stop along a kerb, by stations of the kerb side.
struct BusStop {
  double sign_m = 0;                    ///< position of the front of a stopped bus
  double bay_from_m = 0, bay_to_m = 0;  ///< no parking here
};

/// The kerb of a segment, seen from the block on its left. Stations run along the segment's centre line in
/// the side's direction; `inset` is measured from the kerb into the block.
struct KerbSide {
  Side side;
  Polyline centre;
  double half_width = 0, pavement_m = 0;
  double from = 0, to = 0;  ///< stations between which things may stand, clear of junctions
  Approach approach;        ///< at the junction where the side begins
  double cut_m = 0;         ///< station where that junction ends
  double parking_m = 0;
  /// Direction of traffic at this kerb: against the side's direction (usual, with the block on the traffic's
  /// right) or along it (the left kerb of a one-way street).
  bool meets_traffic = false, runs_with_traffic = false;
  std::optional<BusStop> bus_stop;

  Vec2 at(double s, double inset) const;
  Vec2 direction(double s) const { return station_at(centre, s).direction; }
  /// Heading of a model whose +x faces the carriageway.
  double facing(double s) const;
};

KerbSide kerb_side(const StreetNetwork& network, const Side& side, double pavement_m,
                   const CityOptions& options);

/// The angle of a direction in the plan, anticlockwise from east, radians.
double angle_of(const Vec2& direction);

}  // namespace cps::city
