#include "scenes/city/roadside/vehicles/two_wheeler.h"

#include <cmath>

#include "scenes/city/roadside/vehicles/vehicle_parts.h"

namespace cps::city {
namespace {

/// A rider's hip, shoulder, hand and feet. Hip, shoulder and hand are the right ones and mirrored for the
/// left.
struct Posture {
  Vec3 hip, shoulder, hand, right_foot, left_foot;
};

Vec3 mirrored(const Vec3& p) {
  return {p.x(), p.y(), -p.z()};
}

/// A knee or an elbow: the middle of a limb, displaced by `bend`.
Vec3 joint(const Vec3& from, const Vec3& to, const Vec3& bend) {
  return (from + to) / 2 + bend;
}

void add_rider(Mesh& mesh, const Materials& m, Draws& draws, const Posture& p, bool helmet) {
  const MaterialId coat = draws.one_of(m.cloth), trousers = draws.one_of(m.cloth),
                   skin = draws.one_of(m.skin), hair = draws.one_of(m.hair);
  const auto limb = [&](MaterialId material, const Vec3& from, const Vec3& to, double r0, double r1,
                        int sides = 8) { add_tube(mesh.surfaces[material], from, to, r0, r1, sides, true); };
  for (const double side : {1.0, -1.0}) {
    const auto own = [&](const Vec3& q) { return side > 0 ? q : mirrored(q); };
    const Vec3 foot = side > 0 ? p.right_foot : p.left_foot, hip = own(p.hip);
    const Vec3 knee = joint(hip, foot, {0.20, 0.10, side * 0.03});
    limb(trousers, knee, hip, 0.07, 0.09);
    limb(trousers, foot, knee, 0.05, 0.07);
    add_block(mesh.surfaces[m.car_trim], foot + Vec3(-0.08, -0.06, -0.045), foot + Vec3(0.18, 0.02, 0.045));
    const Vec3 shoulder = own(p.shoulder), hand = own(p.hand);
    const Vec3 elbow = joint(shoulder, hand, {-0.04, -0.05, side * 0.05});
    limb(coat, elbow, shoulder, 0.045, 0.06);
    limb(coat, hand, elbow, 0.035, 0.045);
    limb(skin, hand - Vec3(0.02, 0, 0), hand + Vec3(0.06, -0.01, 0), 0.035, 0.03, 6);
  }
  const Vec3 seat(p.hip.x() - 0.03, p.hip.y() - 0.02, 0), neck(p.shoulder.x(), p.shoulder.y() + 0.05, 0);
  const Vec3 chest = seat + (neck - seat) * 0.55, up = (neck - seat).normalized();
  limb(coat, seat, chest, 0.17, 0.17, 12);
  limb(coat, chest, neck - up * 0.06, 0.17, 0.19, 12);
  limb(coat, neck - up * 0.06, neck + up * 0.02, 0.19, 0.07, 12);
  const Vec3 chin = neck + Vec3(0.06, 0.09, 0);
  limb(skin, neck, chin, 0.055, 0.06, 10);
  limb(skin, chin - Vec3(0, 0.03, 0), chin + Vec3(0.02, 0.09, 0), 0.07, 0.088, 10);
  const MaterialId top = helmet ? draws.one_of(m.car_paint) : hair;
  const double r = helmet ? 0.115 : 0.092;
  limb(top, chin + Vec3(0.01, 0.06, 0), chin + Vec3(0, 0.13, 0), r, r * 0.93, 10);
  limb(top, chin + Vec3(0, 0.13, 0), chin + Vec3(-0.01, 0.19, 0), r * 0.93, r * 0.4, 10);
}

void add_bicycle(Mesh& mesh, const Materials& m, Draws& draws) {
  constexpr double radius = 0.345, tyre = 0.018, rear = -0.52, front = 0.54;
  const MaterialId paint = draws.one_of(m.car_paint);
  const auto tube = [&](MaterialId material, const Vec3& from, const Vec3& to, double r, int sides = 6) {
    add_tube(mesh.surfaces[material], from, to, r, r, sides, true);
  };
  for (const double x : {rear, front}) {
    const Vec3 hub(x, radius, 0);
    add_hoop(mesh.surfaces[m.tyre], hub, radius - tyre, tyre, 24, 6);
    add_hoop(mesh.surfaces[m.rim], hub, radius - 0.045, 0.012, 24, 4);
    tube(m.rim, hub - Vec3(0, 0, 0.04), hub + Vec3(0, 0, 0.04), 0.02);
    for (int i = 0; i < 12; ++i) {
      const double a = 0.5236 * i;
      tube(m.rim, hub, hub + Vec3(std::cos(a), std::sin(a), 0) * (radius - 0.05), 0.0022, 3);
    }
  }
  const Vec3 crank(-0.08, 0.29, 0), seat_top(-0.26, 0.86, 0), head_low(0.40, 0.66, 0),
      head_top(0.36, 0.86, 0);
  tube(paint, crank, seat_top, 0.017);
  tube(paint, crank, head_low, 0.02);
  tube(paint, seat_top - (seat_top - crank) * 0.08, head_top - Vec3(0, 0.05, 0), 0.017);
  tube(paint, head_low - Vec3(-0.01, 0.04, 0), head_top, 0.02);
  tube(m.car_trim, head_top, head_top + Vec3(-0.03, 0.17, 0), 0.014);
  for (const double side : {0.05, -0.05}) {
    tube(paint, {front, radius, side}, head_low + Vec3(0, 0, side), 0.012);
    tube(paint, {rear, radius, side}, crank + Vec3(0, 0, side * 0.6), 0.010);
    tube(paint, {rear, radius, side}, seat_top + Vec3(0.02, -0.06, side * 0.3), 0.008);
  }
  const Vec3 bar = head_top + Vec3(-0.03, 0.17, 0);
  tube(m.car_trim, bar - Vec3(0, 0, 0.29), bar + Vec3(0, 0, 0.29), 0.012);
  tube(m.car_trim, bar + Vec3(0, 0, 0.28), bar + Vec3(-0.12, 0.0, 0.28), 0.016);
  tube(m.car_trim, bar - Vec3(0, 0, 0.28), bar + Vec3(-0.12, 0.0, -0.28), 0.016);
  add_block(mesh.surfaces[m.car_trim], seat_top + Vec3(-0.15, 0.02, -0.07),
            seat_top + Vec3(0.10, 0.07, 0.07));
  tube(m.car_trim, crank - Vec3(0, 0, 0.06), crank + Vec3(0, 0, 0.06), 0.05, 10);
  tube(m.rim, crank + Vec3(0, 0, 0.06), crank + Vec3(0.02, -0.17, 0.08), 0.010);
  tube(m.rim, crank - Vec3(0, 0, 0.06), crank + Vec3(-0.02, 0.17, -0.08), 0.010);
  add_block(mesh.surfaces[m.head_light], head_low + Vec3(0.04, 0.08, -0.03),
            head_low + Vec3(0.09, 0.15, 0.03));
  add_block(mesh.surfaces[m.tail_light], {rear - 0.2, 0.72, -0.03}, {rear - 0.18, 0.78, 0.03});
  add_block(mesh.surfaces[m.car_trim], {rear - 0.18, 0.735, -0.06}, {rear + 0.25, 0.75, 0.06});
}

}  // namespace

Mesh bicycle(const Materials& m, Stream stream) {
  Mesh mesh{"bicycle", {}};
  Draws draws{stream};
  add_bicycle(mesh, m, draws);
  return mesh;
}

Mesh cyclist(const Materials& m, Stream stream) {
  Mesh mesh = bicycle(m, stream);
  mesh.name = "cyclist";
  Draws draws{substream(stream, 1)};
  const double lean = draws.uniform(-0.02, 0.16);
  add_rider(mesh, m, draws,
            {{-0.26, 0.97, 0.09},
             {-0.02 + lean, 1.47 - 0.5 * lean, 0.18},
             {0.27, 1.06, 0.26},
             {-0.06, 0.16, 0.13},
             {-0.10, 0.50, -0.13}},
            draws.chance(0.5));
  return mesh;
}

Mesh motorcyclist(const Materials& m, Stream stream) {
  Mesh mesh{"motorcyclist", {}};
  Draws draws{stream};
  constexpr double radius = 0.31, rear = -0.70, front = 0.72;
  const MaterialId paint = draws.one_of(m.car_paint);
  const auto block = [&](MaterialId material, const Vec3& low, const Vec3& high) {
    add_block(mesh.surfaces[material], low, high);
  };
  for (const double x : {rear, front}) {
    const Vec3 hub(x, radius, 0);
    add_hoop(mesh.surfaces[m.tyre], hub, radius - 0.065, 0.065, 24, 8);
    for (const double side : {1.0, -1.0})
      add_tube(mesh.surfaces[m.rim], hub, hub + Vec3(0, 0, side * 0.035), 0.2, 0.19, 16, true);
  }
  for (const double side : {1.0, -1.0}) {
    add_tube(mesh.surfaces[m.rim], {front, radius, side * 0.1}, {0.42, 0.88, side * 0.1}, 0.025, 0.028, 8,
             true);
    add_tube(mesh.surfaces[m.car_trim], {-0.1, 0.36, side * 0.06}, {rear, radius, side * 0.1}, 0.03, 0.025, 8,
             true);
    add_tube(mesh.surfaces[m.car_trim], {0.40, 0.98, side * 0.05}, {0.30, 1.02, side * 0.38}, 0.015, 0.018, 8,
             true);
  }
  block(m.car_trim, {-0.25, 0.22, -0.17}, {0.36, 0.60, 0.17});   // engine
  block(paint, {-0.12, 0.60, -0.14}, {0.40, 0.86, 0.14});        // tank
  block(m.car_trim, {-0.75, 0.70, -0.13}, {-0.10, 0.80, 0.13});  // seat
  block(paint, {-0.95, 0.66, -0.09}, {-0.45, 0.74, 0.09});
  block(m.tail_light, {-0.97, 0.68, -0.07}, {-0.94, 0.74, 0.07});
  block(m.number_plate, {-0.965, 0.48, -0.10}, {-0.955, 0.62, 0.10});
  block(paint, {front - 0.22, 0.63, -0.07}, {front + 0.22, 0.66, 0.07});  // mudguard
  add_tube(mesh.surfaces[m.car_trim], {0.40, 0.90, 0}, {0.53, 0.90, 0}, 0.07, 0.09, 12, true);
  add_tube(mesh.surfaces[m.head_light], {0.53, 0.90, 0}, {0.545, 0.90, 0}, 0.085, 0.08, 12, true);
  add_tube(mesh.surfaces[m.rim], {0.1, 0.28, 0.19}, {-0.75, 0.40, 0.19}, 0.04, 0.055, 10, true);
  add_rider(
      mesh, m, draws,
      {{-0.32, 0.88, 0.12}, {-0.10, 1.40, 0.20}, {0.28, 1.03, 0.34}, {0.0, 0.36, 0.24}, {0.0, 0.36, -0.24}},
      true);
  return mesh;
}

}  // namespace cps::city
