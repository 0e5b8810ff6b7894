#include "sampler/places/lane_change.h"

#include <cmath>
#include <vector>

#include "scenes/routes.h"

namespace cps {
namespace {

constexpr double change_m = 40;
constexpr double same_direction = 0.985;  // cos 10°

enum ChangeNumber : std::uint64_t { which, progress };

/// Distance to the left at which a lane passes a place in the same direction; 0 if it does not.
double left_offset_m(const Lane& lane, const Eigen::Vector3d& at, const Eigen::Vector2d& heading) {
  const Eigen::Vector2d left(heading.y(), -heading.x());  // in x and z
  for (std::size_t i = 1; i < lane.points.size(); ++i) {
    const Eigen::Vector3d from = lane.points[i - 1].cast<double>() - at,
                          to = lane.points[i].cast<double>() - at;
    const Eigen::Vector2d a(from.x(), from.z()), b(to.x(), to.z());
    const double before = a.dot(heading), after = b.dot(heading);
    if (before > 0 || after <= 0 || std::abs(from.y()) > 1 ||
        (b - a).dot(heading) < same_direction * (b - a).norm())
      continue;
    return (a + (b - a) * (-before / (after - before))).dot(left);
  }
  return 0;
}

}  // namespace

LaneOffset& LaneOffset::operator+=(const LaneOffset& other) {
  lateral_m += other.lateral_m;
  yaw_rad += other.yaw_rad;
  return *this;
}

LaneOffset draw_lane_change(std::span<const Lane> lanes, int lane, double distance_m, Stream stream) {
  const Place place = place_on_lane(lanes[lane], distance_m, 0, 0);
  const Eigen::Vector2d heading(std::cos(place.heading_rad), -std::sin(place.heading_rad));
  std::vector<double> beside_m;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (static_cast<int>(i) == lane || lanes[i].street != lanes[lane].street) continue;
    const double left_m = left_offset_m(lanes[i], place.position, heading);
    const double width_m = 0.5 * (lanes[lane].width_m + lanes[i].width_m);
    if (std::abs(left_m) > 0.8 * width_m && std::abs(left_m) < 1.3 * width_m) beside_m.push_back(left_m);
  }
  if (beside_m.empty()) return {};
  const double whole_m = beside_m[random_below(stream, which, beside_m.size())];
  const double t = random_uniform(stream, progress);
  // A cubic path whose two ends are parallel to the lanes.
  return {.lateral_m = whole_m * t * t * (3 - 2 * t),
          .yaw_rad = std::atan(whole_m * 6 * t * (1 - t) / change_m)};
}

}  // namespace cps
