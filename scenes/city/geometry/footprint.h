#pragma once

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// A building's ground plan: a strip of constant depth along a front line, on the line's left. A front of two
/// points is a rectangle, three make an L around a corner, four a U around a court.
struct Footprint {
  Polyline front;
  std::vector<Vec2> inward;  ///< one per front point: its shift per metre of depth
  double depth_m = 10;

  Vec2 at(std::size_t i, double depth) const { return front[i] + inward[i] * depth; }
  /// The line `depth` metres behind the front, in the same direction.
  Polyline line_at(double depth) const;
  Polygon polygon() const;
  /// The strip with its ends moved outwards along the front, in metres.
  Footprint lengthened(double at_start_m, double at_end_m) const;
};

/// The strip behind `front`, its ends at right angles to the front.
Footprint make_footprint(const Polyline& front, double depth_m);

/// A two-point footprint turned by 90°: its right end becomes the front.
Footprint turned(const Footprint& footprint);

/// A corner of a cross-section: metres behind the front, metres above the ground.
struct ProfilePoint {
  double depth, height;
};

/// Adds the faces that a cross-section sweeps along the front. They face outwards if the section is listed
/// from the front up and over to the back.
void add_loft(Surface& surface, const Footprint& footprint, const std::vector<ProfilePoint>& profile,
              double tile_m);

/// Adds the cross-section as a face at either end.
void add_loft_ends(Surface& surface, const Footprint& footprint, const std::vector<ProfilePoint>& profile,
                   double tile_m, bool start = true, bool end = true);

}  // namespace cps::city
