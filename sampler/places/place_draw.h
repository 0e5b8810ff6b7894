#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "random/counter_hash.h"
#include "sampler/part.h"
#include "sampler/places/lane_traffic.h"
#include "sampler/places/place_strata.h"
#include "sampler/recipe/recipe.h"
#include "scenes/clearance.h"
#include "scenes/rig.h"
#include "scenes/routes.h"
#include "scenes/scene.h"

namespace cps {

/// Where a car may be put in one scene: its lanes, its routes dealt out to the parts, and what stands in the
/// way.
struct DrivableScene {
  std::vector<Lane> lanes;
  std::vector<LaneStretch> usable;  ///< where places are drawn, one per lane
  std::vector<Route> routes;
  std::vector<Part> route_parts;  ///< one per route; all of them `all` when streets are shared
  LaneTraffic traffic;
  SceneRays rays;
};

/// What of each lane is driven on, given each lane's part: all of it where lanes go on, 3 m less at an end
/// without a link, where the road stops; and where a lane leads to another part's, only as far as its middle
/// or 10 m before its end, so that no place there has a twin in the other part.
std::vector<LaneStretch> usable_stretches(std::span<const Lane> lanes, std::span<const Part> lane_parts);

/// Throws std::runtime_error when the scene (called `name` in the message) has no lanes, or too few streets
/// for three parts.
DrivableScene drivable_scene(const Scene& scene, const std::string& name, const Recipe& recipe,
                             Stream stream);

/// How many places were drawn, and what the rejected ones were rejected for.
struct PlaceTally {
  std::int64_t drawn = 0;
  std::array<std::int64_t, place_fault_count> faults = {};  ///< by PlaceFault; none: the accepted ones
  std::int64_t rejected() const { return drawn - faults[static_cast<int>(PlaceFault::none)]; }
  void add(const PlaceTally& other);
  /// For people: `4.1 % of 96 places rejected: 3 too_close, 1 inside`.
  std::string brief() const;
};

struct DrawnPlace {
  std::string street;
  Place place;
  std::vector<RigCamera> cameras;  ///< the rig's, with mount errors
  PlaceTally tally;                ///< of this place and those that were rejected before it
};

/// A place on a route of `part`, uniform along the lanes within its stratum of them, with the recipe's
/// deviations, the car on its wheels, clear of the traffic on the lanes (what is not, is passed over and not
/// counted), where no camera of the rig has a fault. If the stratum has none, its surroundings are tried too.
/// Throws std::runtime_error when 200 attempts find none.
DrawnPlace draw_place(const DrivableScene& scene, const Rig& rig, Part part, const Recipe& recipe,
                      const LaneStratum& stratum, Stream stream);

}  // namespace cps
