#include "distortion/label_algebra.h"

namespace cps {

CalibratedCamera cropped(const CalibratedCamera& calibrated, int x0, int y0, int width, int height) {
  CalibratedCamera result = calibrated;
  result.pinhole.width = width;
  result.pinhole.height = height;
  result.pinhole.cx -= x0;
  result.pinhole.cy -= y0;
  return result;
}

CalibratedCamera padded(const CalibratedCamera& calibrated, int left, int top, int right, int bottom) {
  return cropped(calibrated, -left, -top, left + calibrated.pinhole.width + right,
                 top + calibrated.pinhole.height + bottom);
}

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

CalibratedCamera mirrored_top_bottom(const CalibratedCamera& calibrated) {
  CalibratedCamera result = calibrated;
  result.pinhole.cy = calibrated.pinhole.height - 1 - calibrated.pinhole.cy;
  result.distortion.p1 = -calibrated.distortion.p1;
  return result;
}

CalibratedCamera turned_upside_down(const CalibratedCamera& calibrated) {
  return mirrored_left_right(mirrored_top_bottom(calibrated));
}

}  // namespace cps
