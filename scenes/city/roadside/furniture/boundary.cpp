#include "scenes/city/roadside/furniture/boundary.h"

#include "scenes/city/materials/textures.h"

namespace cps::city {
namespace {

constexpr double half_m = boundary_module_m / 2;
constexpr double foot_m = -0.15;  // deep enough to stay in the ground on any slope

}  // namespace

Mesh picket_fence(const Materials& m) {
  Mesh mesh{"picket fence", {}};
  Surface& wood = mesh.surfaces[m.frame_white];
  for (const double z : {0.28, 0.78}) add_box(wood, {0, 0}, {1, 0}, half_m, 0.02, z, z + 0.08, 1, true);
  for (int i = 0; i < 13; ++i) {
    const double x = -half_m + (i + 0.5) * boundary_module_m / 13;
    add_box(wood, {x, -0.035}, {1, 0}, 0.045, 0.012, 0.08, i % 2 ? 0.98 : 1.02, 1, true);
  }
  add_box(wood, {-half_m + 0.05, 0.03}, {1, 0}, 0.05, 0.045, foot_m, 1.08);
  return mesh;
}

Mesh mesh_fence(const Materials& m) {
  Mesh mesh{"mesh fence", {}};
  Surface& wire = mesh.surfaces[m.fence_wire];
  constexpr double height = 1.45;
  for (int i = 0; i < 20; ++i) {
    const double x = -half_m + (i + 0.5) * 0.1;
    add_box(wire, {x, 0}, {1, 0}, 0.0035, 0.0035, 0.06, height);
  }
  for (int i = 0; i < 7; ++i) {
    const double z = 0.08 + i * (height - 0.12) / 6;
    add_box(wire, {0, 0.006}, {1, 0}, half_m, 0.005, z, z + 0.01, 1, true);
  }
  add_box(wire, {-half_m + 0.03, 0.03}, {1, 0}, 0.03, 0.025, foot_m, height + 0.05);
  return mesh;
}

Mesh low_wall(const Materials& m) {
  Mesh mesh{"low wall", {}};
  add_box(mesh.surfaces[m.plaster[0].material], {0, 0}, {1, 0}, half_m, 0.11, foot_m, 0.62, plaster_tile_m);
  add_box(mesh.surfaces[m.stone.material], {0, 0}, {1, 0}, half_m, 0.14, 0.62, 0.68, m.stone.tile_m, true);
  add_box(mesh.surfaces[m.brick[0].material], {-half_m + 0.15, 0}, {1, 0}, 0.14, 0.14, foot_m, 0.95,
          m.brick[0].tile_m);
  add_box(mesh.surfaces[m.stone.material], {-half_m + 0.15, 0}, {1, 0}, 0.15, 0.15, 0.95, 1.01,
          m.stone.tile_m, true);
  return mesh;
}

Mesh high_wall(const Materials& m) {
  Mesh mesh{"high wall", {}};
  add_box(mesh.surfaces[m.concrete[0].material], {0, 0}, {1, 0}, half_m, 0.07, foot_m, 2.2, concrete_tile_m);
  add_box(mesh.surfaces[m.concrete[0].material], {-half_m + 0.1, 0}, {1, 0}, 0.1, 0.11, foot_m, 2.28,
          concrete_tile_m);
  return mesh;
}

}  // namespace cps::city
