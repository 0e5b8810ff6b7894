#include "scenes/city/roadside/person.h"

namespace cps::city {

Mesh person(const Materials& m, Stream stream) {
  Mesh mesh{"person", {}};
  Draws draws{stream};
  const double k = draws.uniform(1.56, 1.88) / 1.75;  // measures below are those of a 1.75 m person
  const double stride = draws.chance(0.75) ? draws.uniform(0.12, 0.3) : 0.0;
  const MaterialId coat = draws.one_of(m.cloth), trousers = draws.one_of(m.cloth),
                   hair = draws.one_of(m.hair), skin = draws.one_of(m.skin);
  const auto limb = [&](MaterialId material, const Vec3& from, const Vec3& to, double r0, double r1,
                        int sides = 8) {
    add_tube(mesh.surfaces[material], from * k, to * k, r0 * k, r1 * k, sides, true);
  };
  const double coat_hem = draws.uniform(0.62, 0.92);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 hip(0, 0.9, side * 0.09), foot(side * stride, 0.07, side * 0.1),
        knee(side * stride * 0.35 + 0.05 * (stride > 0), 0.49, side * 0.1);
    limb(trousers, foot, knee, 0.055, 0.065);
    limb(trousers, knee, hip, 0.065, 0.085);
    add_box(mesh.surfaces[m.car_trim], Vec2(foot.x() + 0.06, -foot.z()) * k, {1, 0}, 0.13 * k, 0.045 * k, 0,
            0.09 * k);
    const Vec3 shoulder(0, 1.42, side * 0.19), elbow(-side * stride * 0.4, 1.14, side * 0.25),
        hand(-side * stride * 0.9 + 0.08, 0.9, side * 0.24);
    limb(coat, elbow, shoulder, 0.045, 0.06);
    limb(coat, hand, elbow, 0.035, 0.045);
    limb(skin, hand, hand + Vec3(0.02, -0.1, 0), 0.035, 0.02, 6);
  }
  limb(coat, {0, coat_hem, 0}, {0, 1.15, 0}, 0.17, 0.15, 12);
  limb(coat, {0, 1.15, 0}, {0, 1.42, 0}, 0.15, 0.19, 12);
  limb(coat, {0, 1.42, 0}, {0, 1.5, 0}, 0.19, 0.07, 12);
  limb(skin, {0, 1.48, 0}, {0.01, 1.57, 0}, 0.055, 0.06, 10);
  limb(skin, {0.01, 1.55, 0}, {0.02, 1.64, 0}, 0.07, 0.088, 10);
  limb(hair, {0.005, 1.63, 0}, {0, 1.70, 0}, 0.092, 0.085, 10);
  limb(hair, {0, 1.70, 0}, {-0.005, 1.75, 0}, 0.085, 0.04, 10);
  if (draws.chance(0.35))  // a bag on the shoulder
    add_box(mesh.surfaces[draws.one_of(m.cloth)], Vec2(-0.02, 0.28) * k, {1, 0}, 0.15 * k, 0.05 * k, 0.85 * k,
            1.15 * k, 1, true);
  return mesh;
}

}  // namespace cps::city
