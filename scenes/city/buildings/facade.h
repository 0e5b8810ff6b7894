#pragma once

#include <optional>

#include "scenes/city/buildings/doorway.h"
#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"

namespace cps::city {

/// How a house dresses its walls; drawn once per house.
struct FacadeStyle {
  WallMaterial wall, ground_wall;  ///< the ground floor's may differ (plinth, rustication)
  MaterialId frame = 0;
  double bay_m = 2.8;  ///< rhythm of the windows; stretched to fill a wall evenly
  double window_width_m = 1.1, window_height_m = 1.5, sill_m = 0.9;
  double reveal_m = 0.16;
  int mullions = 1;
  bool transom = false;
  bool surrounds = false;  ///< raised frames around windows
  bool balconies = false;  ///< at every other bay of the upper storeys
  double shutter_share = 0.15, curtain_share = 0.35;
};

/// A stretch of wall seen from outside, `from` on the left.
struct Wall {
  Vec2 from, to;
  double bottom = 0, top = 3;  ///< `top` may rise above the last storey (parapet)
  std::vector<double> floors;  ///< heights of the storeys' floors, from `bottom` up
  double eaves = 3;            ///< ceiling of the last storey
};

/// How much of an opening is modelled: everything; without what only a near camera sees; frame and pane
/// alone.
enum class Detail { near_street, upper_storey, plain };

enum class GroundFloor { windows, entrance, shop };

/// Adds the wall with its openings; of walls on a street the upper storeys have less detail than the lower
/// ones. Returns its doorway where it has one.
std::optional<Doorway> add_facade(Mesh& mesh, const Wall& wall, const FacadeStyle& style,
                                  GroundFloor ground_floor, bool on_street, const Materials& materials,
                                  Draws& draws);

/// The same without openings.
void add_blank_wall(Mesh& mesh, const Wall& wall, const WallMaterial& material);

}  // namespace cps::city
