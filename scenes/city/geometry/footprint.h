#pragma once

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// A building's plan: a strip of even depth behind a front of one or more straight pieces, the building on
/// its left. Two points: a plain house; three: around a corner (L); four: around a court (U).
struct Footprint {
  Polyline front;
  std::vector<Vec2> inward;  ///< one per front point: where it moves for each metre of depth
  double depth_m = 10;

  Vec2 at(std::size_t i, double depth) const { return front[i] + inward[i] * depth; }
  /// The line `depth` metres behind the front, in the front's direction.
  Polyline line_at(double depth) const;
  Polygon polygon() const;
  /// The same strip, its ends moved out by `metres` along the front.
  Footprint lengthened(double at_start_m, double at_end_m) const;
};

/// A straight-sided strip at right angles to its front.
Footprint make_footprint(const Polyline& front, double depth_m);

/// The same rectangle (of a two-point footprint) seen from its right end: what ran along the front now runs
/// into the depth.
Footprint turned(const Footprint& footprint);

/// A corner of a cross-section: `depth` behind the front, `height` above the ground.
struct ProfilePoint {
  double depth, height;
};

/// The faces that a cross-section sweeps along the front: outside where it leads up or, at the back, down.
void add_loft(Surface& surface, const Footprint& footprint, const std::vector<ProfilePoint>& profile,
              double tile_m);

/// The cross-section itself as a face at either end.
void add_loft_ends(Surface& surface, const Footprint& footprint, const std::vector<ProfilePoint>& profile,
                   double tile_m, bool start = true, bool end = true);

}  // namespace cps::city
