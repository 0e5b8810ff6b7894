#pragma once

#include "random/counter_hash.h"
#include "scenes/city/geometry/mesh.h"

/// Faces laid along lines of the plan: carriageways, kerbs, pavements, painted lines.
namespace cps::city {

/// How light a weathered ground is at a point, about 1 ± 0.2: what keeps tiled textures from looking alike.
double weathering(Stream stream, const Vec2& point);

/// The horizontal or tilted strip between two lines with equally many points, `left` on the left of `right`.
/// Texture: u along the right line, v across, in metres / `tile_m`.
struct StripStyle {
  double left_height = 0, right_height = 0;
  double tile_m = 1;
};
void add_strip(Surface& surface, const Polyline& left, const Polyline& right, const StripStyle& style);

/// A flat stripe `width_m` wide along a line.
void add_stripe(Surface& surface, const Polyline& centre, double width_m, double height, double tile_m);

}  // namespace cps::city
