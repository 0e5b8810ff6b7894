#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/math/color.h"

namespace cps {

/// A unit vector as a point in [−1, 1]²: the octahedron unfolded to a square (Meyer et al. 2010; Cigolle et
/// al. 2014).
inline Eigen::Vector2f octahedral(const Vec3& v) {
  const Vec3 n = v / v.cwiseAbs().sum();
  if (n.z() >= 0.0f) return n.head<2>();
  return {std::copysign(1.0f - std::abs(n.y()), n.x()), std::copysign(1.0f - std::abs(n.x()), n.y())};
}

inline Vec3 from_octahedral(const Eigen::Vector2f& square) {
  Vec3 n(square.x(), square.y(), 1.0f - std::abs(square.x()) - std::abs(square.y()));
  const float fold = std::max(-n.z(), 0.0f);
  n.x() -= std::copysign(fold, n.x());
  n.y() -= std::copysign(fold, n.y());
  return n.normalized();
}

/// A unit vector in 2 × 16 bits, exact to 0.004°; axis directions are exact.
inline std::uint32_t pack_direction(const Vec3& v) {
  const Eigen::Vector2f o = octahedral(v) * 32767.0f;
  return static_cast<std::uint16_t>(std::lround(o.x())) | static_cast<std::uint32_t>(std::lround(o.y()))
                                                              << 16;
}

inline Vec3 unpack_direction(std::uint32_t bits) {
  return from_octahedral(Eigen::Vector2f(static_cast<float>(static_cast<std::int16_t>(bits & 0xffff)),
                                         static_cast<float>(static_cast<std::int16_t>(bits >> 16))) *
                         (1.0f / 32767.0f));
}

/// All vertex data for shading, in half a cache line. Embree reads the positions in place.
struct PackedVertex {
  Vec3 position;
  std::uint32_t normal;
  std::uint32_t tangent;  ///< towards +u
  float bitangent_sign;   ///< glTF's tangent.w; 0: no tangents
  Eigen::Vector2f uv;
};
static_assert(sizeof(PackedVertex) == 32);

}  // namespace cps
