#pragma once

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// Where people or vehicles come into a building; its threshold lies at the building's own ground level.
struct Doorway {
  Vec2 middle, out;  ///< on the wall; unit, away from it
  double width_m = 1;
  bool is_gate = false;
};

/// A building over level ground.
struct Building {
  Mesh mesh;
  std::vector<Doorway> doorways;
};

}  // namespace cps::city
