#pragma once

#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// A calibrated camera: its pinhole part and its lens. fx and fy may differ.
struct CalibratedCamera {
  std::string name;
  Pinhole pinhole;        ///< of the distorted image
  Distortion distortion;  ///< on the plane z = 1
  bool operator==(const CalibratedCamera&) const = default;
};

}  // namespace cps
