#pragma once

#include <string>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scene.h"

namespace cps {

/// All lanes of one street. They see the same houses, so a route belongs to one split as a whole.
struct Route {
  std::string street;
  std::vector<int> lanes;  ///< indices into Scene::lanes, ascending
  double length_m = 0;     ///< sum over its lanes
};

/// The scene's routes, sorted by street name.
std::vector<Route> routes(const Scene& scene);

/// Length of the lane's centre line, metres.
double length_m(const Lane& lane);

/// A place `distance_m` along the lane (arc length from its first point, clamped to the lane) and `lateral_m`
/// to the left of its centre line at the same height. It heads along the lane, turned by `yaw_offset_rad` to
/// the left, and pitches with the lane's slope. The lane must have at least two points, none equal to the one
/// before (the importer checks this).
Place place_on_lane(const Lane& lane, double distance_m, double lateral_m, double yaw_offset_rad);

}  // namespace cps
