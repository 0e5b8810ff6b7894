#include "scenes/city/roadside/lorry.h"

#include <algorithm>

#include "scenes/city/materials/textures.h"

namespace cps::city {
namespace {

constexpr double front_m = lorry_length_m / 2, half_width_m = lorry_width_m / 2;
constexpr double cab_rear_m = front_m - 1.75, cab_roof_m = 2.65, body_front_m = cab_rear_m - 0.15;

/// A box by its low and high corners: x along the lorry, y to its left, z up.
void add_block(Surface& s, double x0, double x1, double y0, double y1, double z0, double z1,
               double tile_m = 1) {
  add_box(s, {(x0 + x1) / 2, (y0 + y1) / 2}, {1, 0}, (x1 - x0) / 2, (y1 - y0) / 2, z0, z1, tile_m, true);
}

void add_cab(Mesh& mesh, const Materials& m, MaterialId paint) {
  const double w = half_width_m - 0.1;
  add_block(mesh.surfaces[paint], cab_rear_m, front_m - 0.02, -w, w, 0.55, 1.55);
  add_block(mesh.surfaces[paint], cab_rear_m, front_m - 0.18, -w + 0.03, w - 0.03, 1.55, cab_roof_m);
  add_block(mesh.surfaces[m.car_glass], front_m - 0.2, front_m - 0.165, -w + 0.15, w - 0.15, 1.62, 2.4);
  add_block(mesh.surfaces[m.car_trim], front_m - 0.06, front_m, -w, w, 0.32, 0.62);
  add_block(mesh.surfaces[m.car_trim], front_m - 0.04, front_m + 0.0, -0.7, 0.7, 0.8, 1.2);
  add_block(mesh.surfaces[m.number_plate], front_m - 0.02, front_m + 0.012, -0.26, 0.26, 0.42, 0.53);
  for (const double side : {-1.0, 1.0}) {
    const double a = side * (w - 0.04), b = side * (w - 0.015);
    add_block(mesh.surfaces[m.car_glass], cab_rear_m + 0.35, front_m - 0.4, std::min(a, b), std::max(a, b),
              1.65, 2.35);
    const double mirror = side * (w + 0.14);
    add_block(mesh.surfaces[m.car_trim], front_m - 0.3, front_m - 0.2, mirror - 0.09, mirror + 0.09, 1.6,
              2.1);
    const double lamp = side * (w - 0.28);
    add_block(mesh.surfaces[m.head_light], front_m - 0.04, front_m + 0.005, lamp - 0.16, lamp + 0.16, 0.66,
              0.84);
  }
}

void add_wheels(Mesh& mesh, const Materials& m) {
  constexpr double radius = 0.46;
  for (const double axle : {front_m - 1.2, -front_m + 1.9})
    for (const double side : {-1.0, 1.0}) {
      const Vec3 inner(axle, radius, side * (half_width_m - 0.45)),
          outer(axle, radius, side * (half_width_m - 0.12));
      add_tube(mesh.surfaces[m.tyre], inner, outer, radius, radius, 20, true);
      add_tube(mesh.surfaces[m.rim], outer, outer + Vec3(0, 0, side * 0.01), 0.27, 0.25, 16, true);
    }
}

}  // namespace

Mesh lorry(const Materials& m, MaterialId paint) {
  Mesh mesh{"lorry", {}};
  add_cab(mesh, m, paint);
  const double rear = -front_m, w = half_width_m;
  add_block(mesh.surfaces[m.car_trim], rear + 0.1, cab_rear_m, -0.45, 0.45, 0.5, 0.95);
  add_block(mesh.surfaces[m.container_paint.back()], rear, body_front_m, -w, w, 1.0, lorry_height_m,
            sheet_tile_m);
  add_block(mesh.surfaces[m.car_trim], rear + 0.05, rear + 0.15, -w + 0.1, w - 0.1, 0.42, 0.55);
  for (const double side : {-1.0, 1.0}) {
    add_block(mesh.surfaces[m.tail_light], rear + 0.03, rear + 0.06, side * (w - 0.3) - 0.15,
              side * (w - 0.3) + 0.15, 0.6, 0.72);
    add_block(mesh.surfaces[m.car_trim], rear + 2.6, body_front_m - 0.4, side * (w - 0.1) - 0.03,
              side * (w - 0.1) + 0.03, 0.5, 0.95);
  }
  add_wheels(mesh, m);
  return mesh;
}

}  // namespace cps::city
