#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/geometry/footprint.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// What projects from the glass: nothing, vertical fins, horizontal bands, or a grid of both.
enum class CurtainRelief { none, fins, bands, grid };

/// The look of a tower's facades; drawn once per tower.
struct CurtainStyle {
  WallMaterial glass, solid;  ///< solid: of bands and piers
  CurtainRelief relief = CurtainRelief::none;
  double storey_m = 3.6;
  int panels_per_pier = 2;
  double pier_width_m = 0.4, pier_depth_m = 0.3, band_height_m = 1.0, band_depth_m = 0.15;
  int first_panel = 0, first_storey = 0;  ///< offset into the texture tile, so that towers differ
};

CurtainStyle draw_curtain_style(const Materials& materials, Draws& draws);

/// Width of a glass panel.
inline constexpr double curtain_panel_m = 1.8;

/// Adds the wall from `from` to `to` (left to right, seen from outside), `storeys` high from height `bottom`.
void add_curtain_wall(Mesh& mesh, const Vec2& from, const Vec2& to, double bottom, int storeys,
                      const CurtainStyle& style);

}  // namespace cps::city
