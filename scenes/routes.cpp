#include "scenes/routes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cps {

std::vector<Route> routes(const Scene& scene) {
  std::map<std::string, Route> by_street;
  for (std::size_t i = 0; i < scene.lanes.size(); ++i) {
    const Lane& lane = scene.lanes[i];
    Route& route = by_street[lane.street];
    route.street = lane.street;
    route.lanes.push_back(static_cast<int>(i));
    route.length_m += length_m(lane);
  }
  std::vector<Route> sorted;
  for (auto& [street, route] : by_street) sorted.push_back(std::move(route));
  return sorted;
}

double length_m(const Lane& lane) {
  double length = 0;
  for (std::size_t i = 1; i < lane.points.size(); ++i)
    length += (lane.points[i] - lane.points[i - 1]).cast<double>().norm();
  return length;
}

Place place_on_lane(const Lane& lane, double distance_m, double lateral_m, double yaw_offset_rad) {
  std::size_t end = 1;
  double left_m = std::max(distance_m, 0.0);
  const auto segment = [&] {
    return Eigen::Vector3d((lane.points[end] - lane.points[end - 1]).cast<double>());
  };
  double segment_m = segment().norm();
  while (left_m > segment_m && end + 1 < lane.points.size()) {
    left_m -= segment_m;
    ++end;
    segment_m = segment().norm();
  }
  const Eigen::Vector3d along = segment();
  Place place;
  place.position = lane.points[end - 1].cast<double>() + along * std::min(left_m / segment_m, 1.0);
  const double heading = std::atan2(-along.z(), along.x());  // anticlockwise about +y from +x: towards −z
  place.position += lateral_m * Eigen::Vector3d(-std::sin(heading), 0, -std::cos(heading));
  place.heading_rad = heading + yaw_offset_rad;
  place.pitch_rad = std::atan2(along.y(), std::hypot(along.x(), along.z()));
  return place;
}

}  // namespace cps
