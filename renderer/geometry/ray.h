#pragma once

#include <cstdint>
#include <limits>

#include "renderer/math/color.h"

/// Rays and what they meet.
namespace cps {

struct Ray {
  Vec3 origin;
  Vec3 direction;  ///< unit length
  float t_near = 0;
  float t_far = std::numeric_limits<float>::infinity();
  bool from_viewer = false;  ///< meets inside-out shells, which light passes
  bool meets_car = true;     ///< false: passes what rides with the car
  std::uint32_t id = 0;      ///< decides, with the surface, whether a half-transparent surface stops the ray
};

struct Hit {
  static constexpr std::uint32_t no_placement = 0xffffffffu;

  std::uint32_t placement = no_placement;
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  ///< barycentric
  float t = 0;         ///< distance along the ray, metres
  explicit operator bool() const { return placement != no_placement; }
};

/// Number of rays traced as one packet: the width of Embree's rtcIntersect8 and rtcOccluded8.
constexpr int packet_size = 8;

}  // namespace cps
