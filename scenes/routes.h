#pragma once

#include <string>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scene.h"

namespace cps {

/// All lanes of one street. Opposite lanes see the same houses, so a route is never divided between splits.
struct Route {
  std::string street;
  std::vector<int> lanes;  ///< indices into Scene::lanes, ascending
  double length_m = 0;     ///< of all its lanes together
};

/// The scene's routes, sorted by street.
std::vector<Route> routes(const Scene& scene);

/// Length of the lane's centre line.
double length_m(const Lane& lane);

/// A place `distance_m` along the lane (arc length from its first point, held within the lane), `lateral_m`
/// to the left of its centre line at the same height, heading along the lane turned by `yaw_offset_rad` to
/// the left, its nose up as the lane climbs. The lane has at least two points that do not repeat, as the
/// importer makes sure.
Place place_on_lane(const Lane& lane, double distance_m, double lateral_m, double yaw_offset_rad);

}  // namespace cps
