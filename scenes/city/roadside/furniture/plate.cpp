#include "scenes/city/roadside/furniture/plate.h"

#include <cmath>
#include <numbers>

namespace cps::city {

void add_plate(Mesh& mesh, MaterialId front, MaterialId back, int corners, double radius, double height,
               double turn, double forward) {
  std::vector<Vertex> face(corners), reverse(corners);
  for (int i = 0; i < corners; ++i) {
    const double a = turn - 2 * std::numbers::pi * i / corners;
    face[i] = {Vec3(radius * std::cos(a), height + radius * std::sin(a), -forward)};
    reverse[corners - 1 - i] = face[i];
  }
  add_polygon(mesh.surfaces[front], face);
  for (Vertex& v : reverse) v.position.z() += 0.004;
  add_polygon(mesh.surfaces[back], reverse);
}

}  // namespace cps::city
