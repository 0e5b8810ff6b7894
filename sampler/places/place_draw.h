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
#include "scenes/places/lit_view.h"
#include "scenes/places/place_fault.h"
#include "scenes/rig.h"
#include "scenes/routes.h"
#include "scenes/scene.h"

namespace cps {

/// Where a car may stand in one scene: its lanes, its routes assigned to train, val and test, and the
/// obstacles.
struct DrivableScene {
  std::vector<Lane> lanes;
  std::vector<LaneStretch> usable;  ///< stretch of each lane in which places are drawn
  std::vector<Route> routes;
  std::vector<Part> route_parts;  ///< one per route; `all` for every route if the parts share streets
  LaneTraffic traffic;
  SceneRays rays;
  SceneLight light;
};

/// The stretch of each lane in which places are drawn, given the part of each lane: the whole lane, less 3 m
/// at an end without a link, where the road stops, and less 10 m (at most half the lane) where it leads into
/// a lane of another part, so that no place there has a twin in that part.
std::vector<LaneStretch> usable_stretches(std::span<const Lane> lanes, std::span<const Part> lane_parts);

/// Prepares a scene for draw_place(); `stream` decides which route belongs to which part. Throws
/// std::runtime_error if the scene (called `name` in the message) has no lanes, or too few streets for three
/// parts.
DrivableScene drivable_scene(const Scene& scene, const std::string& name, const Recipe& recipe,
                             Stream stream);

/// Number of places drawn, and of those rejected for each fault.
struct PlaceTally {
  std::int64_t drawn = 0;
  std::array<std::int64_t, place_fault_count> faults =
      {};  ///< count by PlaceFault; `none` counts the accepted places
  std::int64_t rejected() const { return drawn - faults[static_cast<int>(PlaceFault::none)]; }
  void add(const PlaceTally& other);
  /// `4.1 % of 96 places rejected: 3 too_close, 1 inside`
  std::string brief() const;
};

struct DrawnPlace {
  std::string street;
  Place place;
  std::vector<RigCamera> cameras;  ///< the cameras of the rig, with mount errors and the recipe's turns
  PlaceTally tally;                ///< counts this place and those rejected before it
};

/// Draws a place on a route of `part`: uniform along the lanes within its stratum, with the recipe's
/// deviations from the lane, the car's wheels on the ground. Rejects places where a camera of the rig has a
/// fault; skips, without counting, those in the traffic on the lanes. If the stratum has no place, its
/// surroundings are tried. Throws std::runtime_error if 200 attempts find none.
DrawnPlace draw_place(const DrivableScene& scene, const Rig& rig, Part part, const Recipe& recipe,
                      const LaneStratum& stratum, Stream stream);

}  // namespace cps
