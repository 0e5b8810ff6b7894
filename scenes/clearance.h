#pragma once

#include <string>

#include "scenes/scene_rays.h"

namespace cps {

/// Why a camera position is rejected.
enum class PlaceFault {
  none,
  inside,     ///< a third of all directions around it show the back of a single-sided surface: it is inside
              ///< something or below the ground
  too_close,  ///< something other than ground is within 45° of its axis and nearer than allowed
  only_sky,   ///< more than three quarters of what lies within 45° of its axis is sky
};
inline constexpr int place_fault_count = 4;

/// The fault's name, for counts and tables.
std::string to_string(PlaceFault fault);

/// The first fault of a camera at `position` (world) that looks along `forward` (any length but 0) and needs
/// `min_distance_m` of free space ahead; none if the place is good.
PlaceFault place_fault(const SceneRays& rays, const Eigen::Vector3d& position, const Eigen::Vector3d& forward,
                       double min_distance_m);

}  // namespace cps
