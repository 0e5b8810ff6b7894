#pragma once

#include <functional>

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// Divides triangles until no edge is longer than `max_edge_m`, seen from above. Whether an edge is halved
/// depends only on its own length, so triangles that share an edge still share its halves.
void refine(Surface& surface, double max_edge_m);

/// Sets the vertex colours to gray, of lightness `light(plan position)`.
void shade(Surface& surface, const std::function<double(const Vec2&)>& light);

}  // namespace cps::city
