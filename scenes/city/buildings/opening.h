#pragma once

#include "scenes/city/buildings/doorway.h"
#include "scenes/city/buildings/facade_style.h"
#include "scenes/city/draws.h"

/// Openings in a wall and what fills them: windows, doors, shop fronts, gates. Coordinates are metres along
/// the wall, height, and metres out of the wall.
namespace cps::city {

/// A wall's frame: u along it (to the right, seen from outside), z up, w outwards.
struct WallFrame {
  Vec2 origin, along, out;
  Vec3 point(double u, double z, double w) const { return lift(origin + along * u + out * w, z); }
};

/// A rectangle of a wall: from u0 to u1 along it and from z0 to z1 in height, metres.
struct WallRectangle {
  double u0, u1, z0, z1;
};

WallFrame make_wall_frame(const Vec2& from, const Vec2& to);

/// A rectangular opening.
struct Opening {
  enum class Kind { window, door, shop, gate } kind = Kind::window;
  double u0, u1, z0, z1;
};

/// The doorway of an opening that is a door or a gate.
Doorway doorway_of(const WallFrame& frame, const Opening& opening);

/// Adds a rectangle `w` metres out of the wall, facing outwards.
void add_panel(Surface& surface, const WallFrame& frame, const WallRectangle& rectangle, double w,
               double tile_m = 1);

/// The sides of a bar. Sides that touch something else need no face.
enum Faces : unsigned {
  no_faces = 0,
  left_face = 1,
  right_face = 2,
  lower_face = 4,
  upper_face = 8,
  all_faces = 15
};

/// Adds a bar that projects from the wall from w0 to w1: its front and the sides in `faces`.
void add_bar(Surface& surface, const WallFrame& frame, const WallRectangle& rectangle, double w0, double w1,
             double tile_m = 1, unsigned faces = all_faces);

/// Adds a stretch of wall with holes for the openings, which are sorted from left to right.
void add_pierced_wall(Surface& surface, const WallFrame& frame, double width, double bottom, double top,
                      const std::vector<Opening>& openings, double tile_m);

/// How finely an opening is modelled: in full; without what only a near camera sees; frame and pane only.
enum class Detail { near_street, upper_storey, plain };

/// Adds a sectional gate, set back into the wall.
void add_gate(Mesh& mesh, const WallFrame& frame, const Opening& opening, MaterialId leaf,
              const Materials& materials);

/// Adds an opening of any kind, with the sides of its hole.
void add_opening(Mesh& mesh, const WallFrame& frame, const Opening& opening, const FacadeStyle& style,
                 const WallMaterial& wall, Detail detail, const Materials& materials, Draws& draws);

}  // namespace cps::city
