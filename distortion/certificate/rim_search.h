#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "distortion/certificate/branch_and_bound.h"
#include "distortion/certificate/rim_gauge.h"
#include "numbers/interval.h"

namespace cps {

/// A piece of a rectangle's side: parallel to the x axis if `is_horizontal`, from `low` to `high` along it,
/// the other coordinate `fixed`.
struct SideSegment {
  bool is_horizontal;
  double low, high, fixed;
};

/// The smallest gauge of points with these x and y.
inline double smallest_gauge(const Eigen::AlignedBox2d& frame, Interval x, Interval y) {
  return std::max(std::max(x.low / frame.max().x(), x.high / frame.min().x()),
                  std::max(y.low / frame.max().y(), y.high / frame.min().y()));
}

/// smallest_rim_gauge() of any map of the plane: `image(point)` is the map, `enclosure(segment)` encloses the
/// x and the y of a segment's image.
template <typename Image, typename Enclosure>
double smallest_gauge_of_rim(const Eigen::AlignedBox2d& rectangle, const Eigen::AlignedBox2d& frame,
                             Image image, Enclosure enclosure) {
  const Eigen::Vector2d low = rectangle.min(), high = rectangle.max();
  double proved = std::numeric_limits<double>::infinity();
  const auto search_side = [&](bool is_horizontal, double fixed) {
    const auto value = [&](double t) {
      return gauge(frame, image(is_horizontal ? Eigen::Vector2d(t, fixed) : Eigen::Vector2d(fixed, t)));
    };
    const auto bound = [&](double t0, double t1, double) {
      const std::array<Interval, 2> xy = enclosure(SideSegment{is_horizontal, t0, t1, fixed});
      return smallest_gauge(frame, xy[0], xy[1]);
    };
    const double tolerance = 1e-11 * std::abs(value(is_horizontal ? low.x() : low.y()));
    const int axis = is_horizontal ? 0 : 1;
    proved = std::min(proved,
                      smallest_value(low[axis], high[axis], {.tolerance = tolerance}, bound, value).proved);
  };
  search_side(true, low.y());
  search_side(true, high.y());
  search_side(false, low.x());
  search_side(false, high.x());
  return proved;
}

}  // namespace cps
