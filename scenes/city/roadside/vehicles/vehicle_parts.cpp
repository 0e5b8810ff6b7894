#include "scenes/city/roadside/vehicles/vehicle_parts.h"

#include <cmath>
#include <numbers>

namespace cps::city {

void add_blocks(Surface& s, const Vec3& low, const Vec3& high) {
  add_block(s, low, high);
  add_block(s, {low.x(), low.y(), -high.z()}, {high.x(), high.y(), -low.z()});
}

void add_truck_wheel(Mesh& mesh, const Materials& m, const Vec3& hub, double radius, double width,
                     double side) {
  const Vec3 inner = hub - Vec3(0, 0, side * width);
  add_tube(mesh.surfaces[m.tyre], inner, hub, radius, radius, 20, true);
  add_tube(mesh.surfaces[m.rim], hub, hub + Vec3(0, 0, side * 0.01), 0.58 * radius, 0.55 * radius, 16, true);
}

void add_hoop(Surface& s, const Vec3& middle, double radius, double tube_radius, int steps, int sides) {
  const auto first = static_cast<std::uint32_t>(s.positions.size());
  for (int i = 0; i <= steps; ++i) {
    const double a = 2 * std::numbers::pi * i / steps;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    for (int k = 0; k <= sides; ++k) {
      const double b = 2 * std::numbers::pi * k / sides;
      const Vec3 normal = out * std::cos(b) + Vec3(0, 0, std::sin(b));
      s.positions.push_back((middle + out * radius + normal * tube_radius).cast<float>());
      s.normals.push_back(normal.cast<float>());
      s.uvs.emplace_back(0.f, 0.f);
    }
  }
  const std::uint32_t row = sides + 1;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < sides; ++k) {
      const std::uint32_t a = first + i * row + k, b = a + row;
      s.indices.insert(s.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
}

}  // namespace cps::city
