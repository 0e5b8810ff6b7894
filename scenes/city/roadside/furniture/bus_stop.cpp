#include "scenes/city/roadside/furniture/bus_stop.h"

#include "scenes/city/roadside/furniture/plate.h"

namespace cps::city {
namespace {

/// Adds a pane without thickness between two points of the plan.
void add_pane(Surface& s, const Vec2& from, const Vec2& to, double bottom, double top) {
  add_quad(s, {lift(from, bottom)}, {lift(to, bottom)}, {lift(to, top)}, {lift(from, top)});
}

}  // namespace

Mesh bus_shelter(const Materials& m) {
  Mesh mesh{"bus shelter", {}};
  constexpr double l = shelter_half_length_m - 0.05, back = -shelter_half_depth_m + 0.08,
                   front = shelter_half_depth_m - 0.05, roof = 2.42;
  for (const double z : {-l, -l / 3, l / 3, l})
    add_block(mesh.surfaces[m.car_trim], {back - 0.03, -0.05, z - 0.03}, {back + 0.03, roof, z + 0.03});
  for (const double z : {-l, l})
    add_block(mesh.surfaces[m.car_trim], {front - 0.43, -0.05, z - 0.03}, {front - 0.37, roof, z + 0.03});
  for (const double height : {0.18, 2.18})
    add_block(mesh.surfaces[m.car_trim], {back - 0.02, height - 0.02, -l}, {back + 0.02, height + 0.02, l});
  add_block(mesh.surfaces[m.car_trim], {back - 0.1, roof, -l - 0.05}, {front + 0.05, roof + 0.1, l + 0.05});
  add_pane(mesh.surfaces[m.clear_glass], {back, l - 0.03}, {back, -l + 0.03}, 0.2, 2.16);
  add_pane(mesh.surfaces[m.clear_glass], {front - 0.4, l}, {back, l}, 0.2, 2.16);
  // A poster case closes the end at +z.
  add_block(mesh.surfaces[m.car_trim], {back + 0.02, 0.25, l - 0.07}, {front - 0.05, 2.15, l + 0.07});
  for (const double side : {-0.072, 0.07})
    add_block(mesh.surfaces[m.shop_sign[side > 0 ? 2 : 4]], {back + 0.1, 0.4, l + side},
              {front - 0.13, 2.05, l + side + 0.002});
  for (const double x : {back + 0.14, back + 0.28, back + 0.42})
    add_block(mesh.surfaces[m.wood], {x - 0.055, 0.44, -l + 0.3}, {x + 0.055, 0.48, l - 0.9});
  for (const double z : {-l + 0.6, l - 1.2})
    add_block(mesh.surfaces[m.pole], {back + 0.1, -0.02, z - 0.03}, {back + 0.46, 0.44, z + 0.03});
  return mesh;
}

Mesh bus_stop_sign(const Materials& m) {
  Mesh mesh{"bus stop sign", {}};
  add_tube(mesh.surfaces[m.pole], {0, -0.05, 0}, {0, 2.85, 0}, 0.035, 0.035, 10, true);
  constexpr double middle = 2.55;
  add_plate(mesh, m.sign_green, m.pole, 28, 0.225, middle, 0, 0.050);
  add_plate(mesh, m.sign_yellow, m.pole, 28, 0.185, middle, 0, 0.056);
  Surface& letter = mesh.surfaces[m.sign_green];
  for (const double x : {-0.07, 0.07})
    add_block(letter, {x - 0.018, middle - 0.1, -0.064}, {x + 0.018, middle + 0.1, -0.058});
  add_block(letter, {-0.06, middle - 0.018, -0.064}, {0.06, middle + 0.018, -0.058});
  add_block(mesh.surfaces[m.sign_white], {-0.17, 1.15, -0.05}, {0.17, 1.75, -0.035});  // timetable
  return mesh;
}

}  // namespace cps::city
