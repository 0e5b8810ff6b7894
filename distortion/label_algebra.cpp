#include "distortion/label_algebra.h"

namespace cps {

CalibratedCamera resized(const CalibratedCamera& calibrated, int width, int height) {
  const Pinhole& old = calibrated.pinhole;
  const double sx = static_cast<double>(width) / old.width, sy = static_cast<double>(height) / old.height;
  CalibratedCamera result = calibrated;
  result.pinhole = {.width = width,
                    .height = height,
                    .fx = sx * old.fx,
                    .fy = sy * old.fy,
                    .cx = sx * (old.cx + 0.5) - 0.5,
                    .cy = sy * (old.cy + 0.5) - 0.5};
  return result;
}

CalibratedCamera mirrored_left_right(const CalibratedCamera& calibrated) {
  CalibratedCamera result = calibrated;
  result.pinhole.cx = calibrated.pinhole.width - 1 - calibrated.pinhole.cx;
  result.distortion.p2 = -calibrated.distortion.p2;
  return result;
}

}  // namespace cps
