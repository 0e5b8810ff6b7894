#pragma once

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/blocks/frontage.h"
#include "scenes/city/draws.h"

namespace cps::city {

/// A block while it is being filled.
struct BlockSite {
  BlockPlan& plan;
  const CityCharacter& character;
  Draws& draws;
  Polygon border;  ///< the inner edge of the pavements
  std::vector<Frontage> sides;
};

/// The frame of a lot at a frontage: u along it from the middle, v into the block, metres.
struct LotFrame {
  Vec2 origin, along;
  Vec2 at(double u, double v) const { return origin + along * u + left_of(along) * v; }
  Polygon rectangle(double u0, double u1, double v0, double v1) const {
    return {at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)};
  }
  Footprint footprint(double u0, double u1, double v0, double v1) const {
    return make_footprint({at(u0, v0), at(u1, v0)}, v1 - v0);
  }
};

/// The frame of the lot over `width_m` of the frontage from station `s`.
LotFrame lot_frame(const Polyline& front, double s, double width_m);

/// Whether the ground lies inside the border (with a tolerance of `slack_m`) and is free of buildings and
/// pads.
bool is_free(const BlockSite& site, const Polygon& ground, double slack_m = 0.05);

/// Adds the building if its ground is free and at least 12 m². Returns whether it did.
bool try_building(BlockSite& site, const BuildingPlan& building);

/// Adds the pad if its ground is free. Returns whether it did. On bent streets it may end a little before or
/// beyond the border.
bool try_pad(BlockSite& site, const Pad& pad);

/// A random number of storeys around the district's mean, clamped to [lowest, highest].
int draw_storeys(BlockSite& site, int lowest, int highest);

/// Adds trees about `spacing_m` apart wherever nothing is built, at least `from_border_m` from the border.
void plant(BlockSite& site, double spacing_m, double from_border_m);

}  // namespace cps::city
