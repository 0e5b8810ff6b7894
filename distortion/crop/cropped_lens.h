#pragma once

#include <Eigen/Geometry>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"

namespace cps {

/// A lens and the part of its image that is kept: all that turning a master into an image needs of a lens.
struct CroppedLens {
  Distortion distortion;
  Pinhole camera;                 ///< of the kept part
  Eigen::AlignedBox2d certified;  ///< rectangle on the plane z = 1 on which the lens is one-to-one
};

}  // namespace cps
