#include "scenes/city/roadside/overhead/wire.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace cps::city {

void add_wire(Surface& s, const Vec3& from, const Vec3& to, double sag_m, double radius_m) {
  constexpr int pieces = 8, sides = 3;
  const auto first = static_cast<std::uint32_t>(s.positions.size());
  const Vec3 aside = Vec3(from.z() - to.z(), 0, to.x() - from.x()).normalized();
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const Vec3 at = from + (to - from) * t - Vec3(0, 4 * sag_m * t * (1 - t), 0);
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * std::numbers::pi * k / sides;
      const Vec3 normal = aside * std::cos(a) + Vec3(0, std::sin(a), 0);
      s.positions.push_back((at + normal * radius_m).cast<float>());
      s.normals.push_back(normal.cast<float>());
      s.uvs.emplace_back(0.f, 0.f);
    }
  }
  for (std::uint32_t i = 0; i < pieces; ++i)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = first + i * sides + k, b = first + i * sides + (k + 1) % sides;
      s.indices.insert(s.indices.end(), {a, b, b + sides, a, b + sides, a + sides});
    }
}

}  // namespace cps::city
