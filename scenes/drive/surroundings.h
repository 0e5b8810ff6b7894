#pragma once

#include <cstdint>

#include "scenes/scene_rays.h"

namespace cps {

/// In which of 16 directions somebody in a car sees a thing that stands there: a steep surface, front or
/// back, within 40 m of the eye.
struct Surroundings {
  std::uint16_t seen = 0;  ///< bit i: direction (cos, sin) of i/16 turns in x and z

  /// Share of the directions: 0 on a lawn or on the sea, .3 to 1 in a street.
  double share() const;
  /// The smaller one of the shares to the left and to the right of a heading (about +y, 0 along +x).
  double on_both_sides(double heading_rad) const;
  /// The share in the directions up to 50° from a heading.
  double ahead(double heading_rad) const;
};

/// Share below which a driver sees little but a plane and the sky.
constexpr double few_things = 0.2;

/// What is seen from a car on `ground` (world).
Surroundings look_around(const SceneRays& rays, const Eigen::Vector3f& ground);

}  // namespace cps
