#pragma once

#include <span>
#include <vector>

#include "trainer/fit/one_camera.h"

namespace cps {

/// The camera that some of the frames give.
struct ConvergencePoint {
  int frames = 0;
  LensPosterior posterior;  ///< in TargetSpace::seen
};

/// fit_one_camera() of 1, 2, 4, 8, … of the frames, then what all give, which is `of_all`. Each more of them
/// contains the ones before; the frames come in random order, the same for equally many frames, because
/// neighbours in a drive show the same street.
std::vector<ConvergencePoint> convergence(std::span<const CameraFrame> frames, const OneCamera& of_all,
                                          const OneCameraOptions& options = {});

}  // namespace cps
