#pragma once

#include "scenes/places/place_fault.h"
#include "scenes/scene_rays.h"

namespace cps {

/// The first fault of what stands around a camera at `position` (world) that looks along `forward` (any
/// length but 0) and needs `min_distance_m` of free space ahead: inside, too_close, only_sky, or none.
PlaceFault clearance_fault(const SceneRays& rays, const Eigen::Vector3d& position,
                           const Eigen::Vector3d& forward, double min_distance_m);

}  // namespace cps
