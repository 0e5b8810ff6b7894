#pragma once

#include "random/counter_hash.h"
#include "scenes/city/geometry/mesh.h"

/// Strips along lines of the plan: carriageways, kerbs, pavements, painted lines.
namespace cps::city {

/// Lightness of weathered ground at a point of the plan, about 0.82 ± 0.16. It varies over many texture
/// tiles, so that the repetition does not show.
double weathering(Stream stream, const Vec2& point);

/// Heights of a strip's edges. Texture coordinates are metres / `tile_m`, u along the right edge and v
/// across.
struct StripStyle {
  double left_height = 0, right_height = 0;
  double tile_m = 1;
};

/// Adds the horizontal or tilted strip between two lines with equally many points.
void add_strip(Surface& surface, const Polyline& left, const Polyline& right, const StripStyle& style);

/// Adds a horizontal stripe `width_m` wide along a line.
void add_stripe(Surface& surface, const Polyline& centre, double width_m, double height, double tile_m);

}  // namespace cps::city
