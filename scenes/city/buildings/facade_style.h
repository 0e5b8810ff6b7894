#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// The look of a building's facades; drawn once per building.
struct FacadeStyle {
  WallMaterial wall, ground_wall;  ///< the ground floor may have another material
  MaterialId frame = 0;
  double bay_m = 2.8;  ///< from window to window; stretched to divide a wall evenly
  double window_width_m = 1.1, window_height_m = 1.5, sill_m = 0.9;
  double reveal_m = 0.16;
  int mullions = 1;
  bool transom = false;
  bool surrounds = false;  ///< raised frames around windows
  bool balconies = false;  ///< at every second bay of the upper storeys
  double shutter_share = 0.15, curtain_share = 0.35;
};

}  // namespace cps::city
