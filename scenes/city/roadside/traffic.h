#pragma once

#include "scenes/city/blocks/district.h"
#include "scenes/city/city_options.h"
#include "scenes/city/roadside/model_library.h"
#include "scenes/city/streets/driving_lanes.h"

/// Frozen traffic: the vehicles on the lanes at one instant.
namespace cps::city {

/// A stretch of a lane that a vehicle occupies, in metres from the lane's first point.
struct OccupiedStretch {
  double from_m = 0, to_m = 0;
};

struct Traffic {
  std::vector<PlacedModel> vehicles;                   ///< on lanes
  std::vector<std::size_t> at_stops;                   ///< indices of those that are buses at stops
  std::vector<PlacedModel> on_tracks;                  ///< cyclists on cycle tracks
  std::vector<std::vector<OccupiedStretch>> occupied;  ///< per lane, ascending; one per vehicle
};

/// Draws queues before stop lines and single vehicles elsewhere on the lanes along segments, each within its
/// lane and none on a crossing or beyond a stop line; buses at stops, close to the kerb; cyclists on the
/// carriageway's cycle tracks. The density depends on the district's style and on `options.traffic`.
Traffic draw_traffic(const StreetNetwork& network, const std::vector<DrivingLane>& lanes,
                     const Districts& districts, const ModelLibrary& models, const CityOptions& options);

}  // namespace cps::city
