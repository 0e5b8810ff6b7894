#pragma once

#include <optional>

#include "scenes/city/buildings/doorway.h"
#include "scenes/city/buildings/facade_style.h"
#include "scenes/city/draws.h"

namespace cps::city {

/// A stretch of wall; seen from outside, `from` is on the left.
struct Wall {
  Vec2 from, to;
  double bottom = 0, top = 3;  ///< `top` may be above the last storey (parapet)
  std::vector<double> floors;  ///< heights of the storeys' floors, ascending from `bottom`
  double eaves = 3;            ///< ceiling of the last storey
};

enum class GroundFloor { windows, entrance, shop };

/// Adds the wall with its openings. On a street, upper storeys have less detail than lower ones. Returns its
/// doorway, if it has one.
std::optional<Doorway> add_facade(Mesh& mesh, const Wall& wall, const FacadeStyle& style,
                                  GroundFloor ground_floor, bool on_street, const Materials& materials,
                                  Draws& draws);

/// Adds the wall without openings.
void add_blank_wall(Mesh& mesh, const Wall& wall, const WallMaterial& material);

}  // namespace cps::city
