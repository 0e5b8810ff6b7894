#pragma once

#include <functional>

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// Divides triangles until no edge is longer than `longest_m`, seen from above. An edge is halved or not by
/// its own length alone, whatever triangle it belongs to, so faces that share an edge go on sharing it.
void refine(Surface& surface, double longest_m);

/// Gives every vertex the lightness of its point of the plan.
void shade(Surface& surface, const std::function<double(const Vec2&)>& light);

}  // namespace cps::city
