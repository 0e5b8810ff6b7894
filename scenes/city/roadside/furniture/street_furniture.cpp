#include "scenes/city/roadside/furniture/street_furniture.h"

#include <cmath>
#include <numbers>

#include "scenes/city/roadside/furniture/plate.h"

namespace cps::city {
namespace {

using std::numbers::pi;

void add_pole(Mesh& mesh, const Materials& m, double height, double radius) {
  add_tube(mesh.surfaces[m.pole], {0, -0.05, 0}, {0, height, 0}, radius, radius, 10, true);
}

}  // namespace

Mesh street_lamp(const Materials& m, double height_m, double arm_m) {
  Mesh mesh{"street lamp", {}};
  Surface& metal = mesh.surfaces[m.pole];
  add_tube(metal, {0, -0.05, 0}, {0, 1.1, 0}, 0.09, 0.09, 12);
  add_tube(metal, {0, 1.1, 0}, {0, height_m, 0}, 0.075, 0.045, 12, true);
  add_tube(metal, {0, height_m - 0.12, 0}, {arm_m, height_m + 0.08, 0}, 0.04, 0.03, 8, true);
  add_box(metal, {arm_m + 0.25, 0}, {1, 0}, 0.38, 0.14, height_m + 0.03, height_m + 0.13, 1, true);
  add_box(mesh.surfaces[m.lamp_glass], {arm_m + 0.3, 0}, {1, 0}, 0.26, 0.11, height_m - 0.01, height_m + 0.03,
          1, true);
  return mesh;
}

Mesh bollard(const Materials& m) {
  Mesh mesh{"bollard", {}};
  add_tube(mesh.surfaces[m.car_trim], {0, -0.05, 0}, {0, 0.85, 0}, 0.055, 0.055, 10, true);
  add_tube(mesh.surfaces[m.sign_white], {0, 0.68, 0}, {0, 0.78, 0}, 0.058, 0.058, 10);
  return mesh;
}

Mesh bin(const Materials& m) {
  Mesh mesh{"bin", {}};
  add_pole(mesh, m, 1.1, 0.03);
  add_tube(mesh.surfaces[m.door_dark], {-0.2, 0.45, 0}, {-0.2, 1.0, 0}, 0.17, 0.19, 12, true);
  return mesh;
}

Mesh bench(const Materials& m) {
  Mesh mesh{"bench", {}};
  for (int i = 0; i < 3; ++i)
    add_box(mesh.surfaces[m.wood], {0.12 - 0.15 * i, 0}, {0, 1}, 0.9, 0.06, 0.42, 0.46, 1, true);
  for (int i = 0; i < 2; ++i)
    add_box(mesh.surfaces[m.wood], {-0.30, 0}, {0, 1}, 0.9, 0.02, 0.56 + 0.16 * i, 0.68 + 0.16 * i, 1, true);
  for (const double y : {-0.7, 0.7}) {
    add_box(mesh.surfaces[m.pole], {-0.06, y}, {1, 0}, 0.22, 0.03, -0.02, 0.42);
    add_box(mesh.surfaces[m.pole], {-0.26, y}, {1, 0}, 0.02, 0.03, 0.40, 0.85);
  }
  return mesh;
}

Mesh switch_box(const Materials& m) {
  Mesh mesh{"switch box", {}};
  add_box(mesh.surfaces[m.concrete[0].material], {0, 0}, {0, 1}, 0.62, 0.2, -0.05, 0.12, 3);
  add_box(mesh.surfaces[m.pole], {0, 0}, {0, 1}, 0.58, 0.17, 0.12, 1.25);
  add_box(mesh.surfaces[m.pole], {0, 0}, {0, 1}, 0.61, 0.2, 1.25, 1.3, 1, true);
  return mesh;
}

Mesh traffic_sign(const Materials& m, SignKind kind) {
  Mesh mesh{"traffic sign", {}};
  constexpr double middle = 2.35;
  add_pole(mesh, m, kind == SignKind::yield ? 2.5 : 2.7, 0.035);
  const auto disc = [&](MaterialId material, double radius, double forward) {
    add_plate(mesh, material, m.pole, 28, radius, middle, 0, forward);
  };
  const auto square = [&](MaterialId material, double radius, double forward, double turn) {
    add_plate(mesh, material, m.pole, 4, radius, middle, turn, forward);
  };
  switch (kind) {
    case SignKind::no_stopping:
      disc(m.sign_red, 0.30, 0.050);
      disc(m.sign_blue, 0.235, 0.056);
      break;
    case SignKind::yield:
      add_plate(mesh, m.sign_red, m.pole, 3, 0.52, middle, -pi / 2, 0.050);
      add_plate(mesh, m.sign_white, m.pole, 3, 0.33, middle, -pi / 2, 0.056);
      break;
    case SignKind::priority:
      square(m.sign_white, 0.42, 0.050, 0);
      square(m.shop_sign[4], 0.30, 0.056, 0);
      break;
    case SignKind::parking:
      square(m.sign_blue, 0.40, 0.050, pi / 4);
      add_plate(mesh, m.sign_white, m.pole, 4, 0.10, middle + 0.08, pi / 4, 0.056);
      break;
    case SignKind::crossing:
      square(m.sign_blue, 0.42, 0.050, pi / 4);
      add_plate(mesh, m.sign_white, m.pole, 3, 0.27, middle - 0.04, pi / 2, 0.056);
      break;
    case SignKind::speed:
      disc(m.sign_red, 0.30, 0.050);
      disc(m.sign_white, 0.235, 0.056);
      break;
  }
  return mesh;
}

Mesh traffic_light(const Materials& m, bool green) {
  Mesh mesh{"traffic light", {}};
  add_pole(mesh, m, 3.3, 0.06);
  add_box(mesh.surfaces[m.signal_off], {0, 0.16}, {1, 0}, 0.15, 0.1, 2.35, 3.25, 1, true);
  const std::array<MaterialId, 3> lights{green ? m.signal_off : m.signal_red, m.signal_off,
                                         green ? m.signal_green : m.signal_off};
  for (int i = 0; i < 3; ++i) {
    const double z = 3.08 - 0.28 * i;
    add_plate(mesh, lights[i], m.signal_off, 20, 0.1, z, 0, 0.265);
    // A visor above each light.
    add_box(mesh.surfaces[m.signal_off], {0, 0.33}, {1, 0}, 0.11, 0.07, z + 0.10, z + 0.115, 1, true);
  }
  return mesh;
}

}  // namespace cps::city
