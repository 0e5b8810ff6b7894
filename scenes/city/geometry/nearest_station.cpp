#include "scenes/city/geometry/nearest_station.h"

#include <algorithm>
#include <limits>

namespace cps::city {

double nearest_station(const Polyline& line, const Vec2& point) {
  double nearest_m = std::numeric_limits<double>::max(), station = 0, before = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 step = line[i] - line[i - 1];
    const double t = std::clamp((point - line[i - 1]).dot(step) / step.squaredNorm(), 0.0, 1.0);
    if (const double d = (line[i - 1] + step * t - point).norm(); d < nearest_m) {
      nearest_m = d;
      station = before + t * step.norm();
    }
    before += step.norm();
  }
  return station;
}

}  // namespace cps::city
