#pragma once

#include "scenes/city/city_options.h"
#include "scenes/city/streets/street_network.h"

/// The shapes of junctions, and the outlines of blocks, which follow the junctions' rounded kerbs.
namespace cps::city {

/// Draws roundabouts and kerb radii, and sets where each segment's own carriageway begins (`cut_from`,
/// `cut_to`).
void shape_junctions(StreetNetwork& network, const CityOptions& options);

/// The border of a junction's asphalt, from arm to arm around the rounded kerbs, anticlockwise. Empty if no
/// road leads there.
Polygon junction_border(const StreetNetwork& network, int junction);

/// A line around a block, anticlockwise.
struct Outline {
  Polygon points;
  std::vector<int> side;     ///< the block's side that the edge after this point belongs to
  std::vector<bool> corner;  ///< whether that edge is part of a rounded corner
};

/// The line `inset_m` (per side of the block) behind the kerb. Corners are rounded by the kerb radius less
/// `corner_shrink_m`; at a roundabout the line follows the ring's kerb, moved back by `corner_shrink_m`. All
/// outlines of a block have the same number of points, so that two of them bound a strip.
Outline outline(const StreetNetwork& network, const Block& block, const std::vector<double>& inset_m,
                double corner_shrink_m);

}  // namespace cps::city
