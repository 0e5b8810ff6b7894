#pragma once

#include <cmath>

#include "renderer/math/color.h"

namespace cps {

/// An orthonormal frame with `normal` as its z axis. BSDFs are evaluated in such a frame.
struct Frame {
  Vec3 tangent, bitangent, normal;

  Vec3 to_local(const Vec3& v) const { return {v.dot(tangent), v.dot(bitangent), v.dot(normal)}; }
  Vec3 to_world(const Vec3& v) const { return v.x() * tangent + v.y() * bitangent + v.z() * normal; }
};

/// A frame around a unit vector, continuous except where n.z changes sign (Duff et al. 2017, "Building an
/// orthonormal basis, revisited").
inline Frame frame_around(const Vec3& n) {
  const float sign = std::copysign(1.0f, n.z());
  const float a = -1.0f / (sign + n.z());
  const float b = n.x() * n.y() * a;
  return {
      {1.0f + sign * n.x() * n.x() * a, sign * b, -sign * n.x()}, {b, sign + n.y() * n.y() * a, -n.y()}, n};
}

}  // namespace cps
