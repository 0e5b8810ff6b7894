#include "scenes/city/roadside/vehicles/lorry.h"

#include "scenes/city/materials/textures.h"
#include "scenes/city/roadside/vehicles/vehicle_parts.h"

namespace cps::city {
namespace {

constexpr double front_m = lorry_length_m / 2, half_width_m = lorry_width_m / 2;
constexpr double cab_rear_m = front_m - 1.75, cab_roof_m = 2.65, body_front_m = cab_rear_m - 0.15;

void add_cab(Mesh& mesh, const Materials& m, MaterialId paint) {
  constexpr double w = half_width_m - 0.1, lamp = w - 0.28, mirror = w + 0.14;
  add_block(mesh.surfaces[paint], {cab_rear_m, 0.55, -w}, {front_m - 0.02, 1.55, w});
  add_block(mesh.surfaces[paint], {cab_rear_m, 1.55, -w + 0.03}, {front_m - 0.18, cab_roof_m, w - 0.03});
  add_block(mesh.surfaces[m.car_glass], {front_m - 0.2, 1.62, -w + 0.15}, {front_m - 0.165, 2.4, w - 0.15});
  add_block(mesh.surfaces[m.car_trim], {front_m - 0.06, 0.32, -w}, {front_m, 0.62, w});
  add_block(mesh.surfaces[m.car_trim], {front_m - 0.04, 0.8, -0.7}, {front_m, 1.2, 0.7});
  add_block(mesh.surfaces[m.number_plate], {front_m - 0.02, 0.42, -0.26}, {front_m + 0.012, 0.53, 0.26});
  add_blocks(mesh.surfaces[m.car_glass], {cab_rear_m + 0.35, 1.65, w - 0.04},
             {front_m - 0.4, 2.35, w - 0.015});
  add_blocks(mesh.surfaces[m.car_trim], {front_m - 0.3, 1.6, mirror - 0.09},
             {front_m - 0.2, 2.1, mirror + 0.09});
  add_blocks(mesh.surfaces[m.head_light], {front_m - 0.04, 0.66, lamp - 0.16},
             {front_m + 0.005, 0.84, lamp + 0.16});
}

}  // namespace

Mesh lorry(const Materials& m, MaterialId paint) {
  Mesh mesh{"lorry", {}};
  add_cab(mesh, m, paint);
  constexpr double rear = -front_m, w = half_width_m;
  add_block(mesh.surfaces[m.car_trim], {rear + 0.1, 0.5, -0.45}, {cab_rear_m, 0.95, 0.45});
  add_block(mesh.surfaces[m.container_paint.back()], {rear, 1.0, -w}, {body_front_m, lorry_height_m, w},
            sheet_tile_m);
  add_block(mesh.surfaces[m.car_trim], {rear + 0.05, 0.42, -w + 0.1}, {rear + 0.15, 0.55, w - 0.1});
  add_blocks(mesh.surfaces[m.tail_light], {rear + 0.03, 0.6, w - 0.45}, {rear + 0.06, 0.72, w - 0.15});
  add_block(mesh.surfaces[m.number_plate], {rear + 0.035, 0.62, -0.26}, {rear + 0.06, 0.73, 0.26});
  add_blocks(mesh.surfaces[m.car_trim], {rear + 2.6, 0.5, w - 0.13}, {body_front_m - 0.4, 0.95, w - 0.07});
  for (const double axle : {front_m - 1.2, rear + 1.9})
    for (const double side : {1.0, -1.0})
      add_truck_wheel(mesh, m, {axle, 0.46, side * (w - 0.12)}, 0.46, 0.33, side);
  return mesh;
}

}  // namespace cps::city
