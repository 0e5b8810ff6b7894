#pragma once

#include "scenes/city/buildings/facade.h"

/// What fills the holes in a wall: windows, doors, shop fronts. Measures are metres along the wall, height,
/// and out of the wall.
namespace cps::city {

/// A wall's own frame: u along it (to the right, seen from outside), z up, w outwards.
struct WallFrame {
  Vec2 origin, along, out;
  Vec3 point(double u, double z, double w) const { return lift(origin + along * u + out * w, z); }
};

WallFrame make_wall_frame(const Vec2& from, const Vec2& to);

/// A rectangle of the wall.
struct Opening {
  enum class Kind { window, door, shop, gate } kind = Kind::window;
  double u0, u1, z0, z1;
};

/// The way in through a door or a gate of the wall.
Doorway doorway_of(const WallFrame& frame, const Opening& opening);

/// The rectangle at `w` metres out of the wall, facing outwards.
void add_panel(Surface& surface, const WallFrame& frame, double u0, double u1, double z0, double z1, double w,
               double tile_m = 1);

/// The sides of a bar: those that touch something else need no faces.
enum Faces : unsigned {
  no_faces = 0,
  left_face = 1,
  right_face = 2,
  lower_face = 4,
  upper_face = 8,
  all_faces = 15
};

/// A bar standing out of the wall from w0 to w1: its front and the named sides.
void add_bar(Surface& surface, const WallFrame& frame, double u0, double u1, double z0, double z1, double w0,
             double w1, double tile_m = 1, unsigned faces = all_faces);

/// A stretch of wall with its openings (from left to right) cut out.
void add_pierced_wall(Surface& surface, const WallFrame& frame, double width, double bottom, double top,
                      const std::vector<Opening>& openings, double tile_m);

/// A sectional or roller gate, set back into the wall.
void add_gate(Mesh& mesh, const WallFrame& frame, const Opening& opening, MaterialId leaf,
              const Materials& materials);

/// Any opening, with the sides of its hole.
void add_opening(Mesh& mesh, const WallFrame& frame, const Opening& opening, const FacadeStyle& style,
                 const WallMaterial& wall, Detail detail, const Materials& materials, Draws& draws);

}  // namespace cps::city
