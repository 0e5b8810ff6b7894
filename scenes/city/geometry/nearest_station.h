#pragma once

#include "scenes/city/geometry/plan_geometry.h"

namespace cps::city {

/// The station (metres along the line) of the line's point nearest to `point`.
double nearest_station(const Polyline& line, const Vec2& point);

}  // namespace cps::city
