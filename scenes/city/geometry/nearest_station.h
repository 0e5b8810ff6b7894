#pragma once

#include "scenes/city/geometry/plan_geometry.h"

namespace cps::city {

/// Where along the line its nearest point to `point` lies, in metres.
double nearest_station(const Polyline& line, const Vec2& point);

}  // namespace cps::city
