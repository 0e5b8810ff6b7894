#pragma once

#include "scenes/city/geometry/mesh.h"

namespace cps::city {

/// An entrance for people or vehicles. Its threshold is at the building's own ground level.
struct Doorway {
  Vec2 middle, out;  ///< middle: on the wall; out: unit, away from the wall
  double width_m = 1;
  bool is_gate = false;
};

/// A building's mesh, on level ground, and its entrances.
struct Building {
  Mesh mesh;
  std::vector<Doorway> doorways;
};

}  // namespace cps::city
