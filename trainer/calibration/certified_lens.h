#pragma once

#include "distortion/calibrated_camera.h"

namespace cps {

/// A predicted camera, changed as little as needed so that its lens is certified.
struct CertifiedLens {
  CalibratedCamera camera;
  double kept = 1;  ///< factor on the predicted distortion coefficients; 1: as predicted
};

/// The predicted lens as it is if it is certified on its frame (eigenvalues between .15 and 1.8, as for drawn
/// lenses). Otherwise all five coefficients are multiplied by the largest factor that makes it so, found by
/// bisection to 1e-6. A principal point outside the frame is moved to its edge. Such a factor always exists:
/// the set of certified lenses is convex and contains the undistorted lens.
CertifiedLens pull_to_certified(const CalibratedCamera& predicted);

}  // namespace cps
