#pragma once

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// A strong barrel: the radial terms of KITTI's camera 3, in units of the base frame's half diagonal, and
/// some tangential ones.
inline Distortion barrel(const Pinhole& base) {
  const Distortion scaled{-0.512, 0.354, -0.150, 0.002, -0.001};
  return rescaled(scaled, 1 / (0.5 * frame_on_plane(base).diagonal().norm()));
}

}  // namespace cps
