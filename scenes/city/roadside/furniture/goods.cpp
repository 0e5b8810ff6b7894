#include "scenes/city/roadside/furniture/goods.h"

#include "scenes/city/materials/textures.h"

namespace cps::city {

namespace {

constexpr double height_m = 2.59;

void add_container(Mesh& mesh, const Materials& m, MaterialId paint, double foot) {
  constexpr double half_length = 3.03, half_width = 1.22;
  const double height = foot + height_m;
  add_box(mesh.surfaces[paint], {0, 0}, {1, 0}, half_length - 0.04, half_width - 0.03, foot + 0.12,
          height - 0.04, sheet_tile_m);
  Surface& frame = mesh.surfaces[m.car_trim];
  for (const double x : {-half_length + 0.06, half_length - 0.06})
    for (const double y : {-half_width + 0.06, half_width - 0.06})
      add_box(frame, {x, y}, {1, 0}, 0.07, 0.07, foot, height, 1, true);
  for (const double y : {-half_width + 0.06, half_width - 0.06})
    add_box(frame, {0, y}, {1, 0}, half_length - 0.13, 0.06, foot + 0.02, foot + 0.16, 1, true);
  for (const double y : {-0.75, -0.3, 0.3, 0.75})  // locking bars of the doors
    add_tube(mesh.surfaces[m.pole], {half_length - 0.02, foot + 0.2, y},
             {half_length - 0.02, height - 0.15, y}, 0.02, 0.02, 6);
}

}  // namespace

Mesh container(const Materials& m, MaterialId paint) {
  Mesh mesh{"container", {}};
  add_container(mesh, m, paint, 0);
  return mesh;
}

Mesh container_stack(const Materials& m) {
  Mesh mesh{"container stack", {}};
  add_container(mesh, m, m.container_paint[0], 0);
  add_container(mesh, m, m.container_paint[1], height_m);
  return mesh;
}

Mesh pallets(const Materials& m) {
  Mesh mesh{"pallets", {}};
  for (const double x : {-0.65, 0.65}) {
    for (int i = 0; i < 3; ++i)
      add_box(mesh.surfaces[m.wood], {x, -0.45 + 0.45 * i}, {1, 0}, 0.6, 0.05, 0, 0.13, 1);
    add_box(mesh.surfaces[m.wood], {x, 0}, {1, 0}, 0.6, 0.5, 0.12, 0.145, 1, true);
    add_box(mesh.surfaces[x < 0 ? m.concrete[1].material : m.sign_white], {x, 0}, {1, 0}, 0.55, 0.46, 0.145,
            x < 0 ? 1.15 : 1.5, 3);
  }
  return mesh;
}

Mesh silo(const Materials& m) {
  Mesh mesh{"silo", {}};
  Surface& metal = mesh.surfaces[m.sheet[0].material];
  add_tube(metal, {0, 2.2, 0}, {0, 9.5, 0}, 1.5, 1.5, 24, false, sheet_tile_m);
  add_tube(metal, {0, 9.5, 0}, {0, 10.6, 0}, 1.5, 0.3, 24, true, sheet_tile_m);
  add_tube(metal, {0, 2.2, 0}, {0, 0.9, 0}, 1.5, 0.25, 24, true, sheet_tile_m);
  for (const double x : {-1.05, 1.05})
    for (const double y : {-1.05, 1.05}) add_box(mesh.surfaces[m.pole], {x, y}, {1, 0}, 0.1, 0.1, -0.05, 2.6);
  return mesh;
}

}  // namespace cps::city
