#pragma once

#include "distortion/calibrated_camera.h"
#include "distortion/image_size.h"
#include "trainer/calibration/targets.h"

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

/// The outputs, for an image of this size, as they are if they describe no camera, or one whose lens is
/// one-to-one in its frame. Otherwise with the distortion coefficients multiplied by the largest factor that
/// makes it so, found by bisection to 1e-6; in TargetSpace::seen, the H-FOV that is seen stays. A principal
/// point outside the frame is moved to its edge.
Outputs pulled_to_one_to_one(const Outputs& outputs, TargetSpace space, const ImageSize& size);

}  // namespace cps
