#pragma once

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// KITTI's camera 3 in its base frame, scaled by the half diagonal: a strong, ordinary barrel.
inline Distortion barrel(const Pinhole& base) {
  const Distortion scaled{-0.512, 0.354, -0.150, 0.002, -0.001};
  return rescaled(scaled, 1 / (0.5 * frame_on_plane(base).diagonal().norm()));
}

}  // namespace cps
