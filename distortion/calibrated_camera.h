#pragma once

#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// A camera as a calibration describes it: what its image's pixels mean. fx and fy may differ.
struct CalibratedCamera {
  std::string name;
  Pinhole camera;         ///< of the distorted image
  Distortion distortion;  ///< on the plane z = 1
  bool operator==(const CalibratedCamera&) const = default;
};

}  // namespace cps
