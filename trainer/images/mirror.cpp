#include "trainer/images/mirror.h"

namespace cps {

Calibration mirrored(const Calibration& calibration) {
  Calibration flipped = calibration;
  flipped.camera.cx = calibration.camera.width - 1 - calibration.camera.cx;
  flipped.distortion.p2 = -calibration.distortion.p2;
  return flipped;
}

}  // namespace cps
