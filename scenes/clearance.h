#pragma once

#include <string>

#include "scenes/scene_rays.h"

namespace cps {

/// Why a camera cannot stand somewhere.
enum class PlaceFault {
  none,
  inside,     ///< a third of all directions around it show the back of a single-sided surface: it is inside
              ///< something or below the ground
  too_close,  ///< something, the ground apart, stands within 45° of its axis and nearer than allowed
  only_sky,   ///< less than a quarter of what lies within 45° of its axis is anything but sky
};
inline constexpr int place_fault_count = 4;

/// The words under which they are counted.
std::string to_string(PlaceFault fault);

/// What is wrong with a camera at `position` (world) that looks along `forward` (any length but 0), nothing
/// nearer than `min_distance_m` before it: the first of the faults that holds, or none.
PlaceFault place_fault(const SceneRays& rays, const Eigen::Vector3d& position, const Eigen::Vector3d& forward,
                       double min_distance_m);

}  // namespace cps
