#pragma once

#include <Eigen/Geometry>

#include "renderer/math/color.h"

namespace cps {

/// Bounds of a group of lamps: where they are and where they shine. All their directions of full strength lie
/// within a cone around `axis`; their light ends at an angle beyond that cone.
struct LampBounds {
  Eigen::AlignedBox3f box;
  Vec3 axis = Vec3::UnitZ();
  float cos_cone = 1;     ///< of the cone's half angle: 1 for one direction, −1 for all
  float cos_falloff = 0;  ///< of the angle beyond it, 0 for surfaces
  float intensity = 0;    ///< along the axis, kcd
  bool two_sided = false;
};

}  // namespace cps
