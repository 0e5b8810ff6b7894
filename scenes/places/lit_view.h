#pragma once

#include <vector>

#include "scenes/places/place_fault.h"
#include "scenes/scene_rays.h"

namespace cps {

/// What lights a scene besides the sky, and what its surfaces make of it.
struct SceneLight {
  std::vector<PunctualLight> lights;
  std::vector<float> albedo;          ///< of each instance: mean over its texture
  std::vector<float> emitted_kcd_m2;  ///< by each instance
  float max_received_kcd_m2 = 0;  ///< mean luminance around a point, at most; unbounded where there are lamps
};

SceneLight scene_light(const Scene& scene);

/// Whether a camera at `position` (world) that looks along `forward` (any length but 0) would take a picture
/// by day: dark, blown_out, or none. An estimate from a few hundred rays, with light from a sky of even
/// luminance, lamps and shining surfaces after at most one reflection, metered as meter_exposure() does.
PlaceFault light_fault(const SceneRays& rays, const SceneLight& light, const Eigen::Vector3d& position,
                       const Eigen::Vector3d& forward);

}  // namespace cps
