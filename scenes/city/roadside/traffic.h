#pragma once

#include "scenes/city/blocks/district.h"
#include "scenes/city/roadside/model_library.h"
#include "scenes/city/streets/driving_lanes.h"

/// The vehicles that an instant of traffic leaves on the lanes.
namespace cps::city {

/// A stretch of a lane that something stands on: metres from the lane's first point.
struct OccupiedStretch {
  double from_m = 0, to_m = 0;
};

struct Traffic {
  std::vector<PlacedModel> vehicles;                   ///< on lanes
  std::vector<std::size_t> at_stops;                   ///< those of them that are buses at their stops
  std::vector<PlacedModel> on_tracks;                  ///< cyclists beside the lanes
  std::vector<std::vector<OccupiedStretch>> occupied;  ///< by lane, ascending: one for each vehicle
};

/// Queues before stop lines and single vehicles elsewhere, on the lanes between junctions: none on a crossing
/// or past a stop line, each within its lane; buses at their stops, as near to the kerb as they get; cyclists
/// on the carriageway's cycle tracks. Denser by style (the district's) and by `options.traffic`.
Traffic draw_traffic(const StreetNetwork& network, const std::vector<DrivingLane>& lanes,
                     const Districts& districts, const ModelLibrary& models, const CityOptions& options);

}  // namespace cps::city
