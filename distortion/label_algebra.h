#pragma once

#include "distortion/calibrated_camera.h"

/// What becomes of a calibration when its image is cut, scaled or turned over. Each function is exact: the
/// ray behind a point of the image is the ray behind the point it was moved to (mirrored, where the image
/// was). Names are kept. Not checked: sizes must be positive; a crop may leave the principal point outside.
namespace cps {

/// The image that starts at column `x0` and row `y0` of the old one. The coefficients stay: they live on the
/// plane z = 1.
CalibratedCamera cropped(const CalibratedCamera& calibrated, int x0, int y0, int width, int height);

/// The image with so many columns and rows added on each side.
CalibratedCamera padded(const CalibratedCamera& calibrated, int left, int top, int right, int bottom);

/// The image resampled to another size, each axis by its own factor s = new/old. Areas of pixels are what is
/// scaled, so a column c becomes s(c + .5) − .5.
CalibratedCamera resized(const CalibratedCamera& calibrated, int width, int height);

/// Left and right exchanged: cx → W − 1 − cx, and p2, whose terms are even in x, changes its sign.
CalibratedCamera mirrored_left_right(const CalibratedCamera& calibrated);

/// Top and bottom exchanged: cy → H − 1 − cy, and p1 changes its sign.
CalibratedCamera mirrored_top_bottom(const CalibratedCamera& calibrated);

/// Turned by 180°: the image of a camera mounted upside down.
CalibratedCamera turned_upside_down(const CalibratedCamera& calibrated);

}  // namespace cps
