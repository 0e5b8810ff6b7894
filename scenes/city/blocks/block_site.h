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
  Polygon border;  ///< where the pavements end
  std::vector<Frontage> sides;
};

/// A rectangle of ground by a frontage: u along it from the middle, v into the block, metres.
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

/// The frame over `width_m` metres of the frontage from station `s`.
LotFrame lot_frame(const Polyline& front, double s, double width_m);

/// Whether the ground lies inside the border (to `slack_m`) and nothing is built or paved there.
bool is_free(const BlockSite& site, const Polygon& ground, double slack_m = 0.05);

/// Plans the building if its ground is free and of some size; whether it did.
bool try_building(BlockSite& site, const BuildingPlan& building);

/// Lays the pad if its ground is free; whether it did. On bent streets it may end a little short of the
/// border or beyond.
bool try_pad(BlockSite& site, const Pad& pad);

/// The block's usual number of storeys, drawn around its district's.
int draw_storeys(BlockSite& site, int lowest, int highest);

/// Trees wherever nothing is built, about `spacing_m` metres apart.
void plant(BlockSite& site, double spacing_m, double from_border_m);

}  // namespace cps::city
