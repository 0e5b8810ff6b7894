#pragma once

#include "trainer/calibration/targets.h"

namespace cps {

/// A calibration that is certain to be one, made of what was predicted.
struct CertifiedLens {
  Calibration calibration;
  double kept = 1;  ///< share of the predicted coefficients: 1, they are as predicted
};

/// The lens as it is where it is certified on its frame (eigenvalues between .15 and 1.8, as drawn lenses
/// are); else with all five coefficients multiplied by the largest share with which it is, found by
/// bisection to 1e-6, and a principal point outside the frame moved to its edge. The set of certified lenses
/// is convex and holds the undistorted one, so there is such a share.
CertifiedLens pull_to_certified(const Calibration& calibration);

}  // namespace cps
