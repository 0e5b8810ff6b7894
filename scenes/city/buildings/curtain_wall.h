#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/geometry/footprint.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// What stands out from the glass: nothing, fins, the floors' edges, or a grid of both.
enum class CurtainRelief { none, fins, bands, grid };

/// How a tower dresses its shaft; drawn once per tower.
struct CurtainStyle {
  WallMaterial glass, solid;  ///< solid: bands and piers
  CurtainRelief relief = CurtainRelief::none;
  double storey_m = 3.6;
  int panels_per_pier = 2;
  double pier_width_m = 0.4, pier_depth_m = 0.3, band_height_m = 1.0, band_depth_m = 0.15;
  int first_panel = 0, first_storey = 0;  ///< where the tile begins, so that towers differ
};

CurtainStyle draw_curtain_style(const Materials& materials, Draws& draws);

/// Glass panels 1.8 m wide.
inline constexpr double curtain_panel_m = 1.8;

/// The wall from `from` to `to` (seen from outside: left to right), `storeys` high from `bottom`.
void add_curtain_wall(Mesh& mesh, const Vec2& from, const Vec2& to, double bottom, int storeys,
                      const CurtainStyle& style);

}  // namespace cps::city
