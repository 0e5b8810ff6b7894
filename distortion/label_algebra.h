#pragma once

#include "distortion/calibrated_camera.h"

/// The calibration of an image that was resized or mirrored. Exact: the ray behind a point of the old image
/// is the ray (mirrored, where the image was) behind the same point of the new one. Names are kept. Not
/// checked: sizes must be positive.
namespace cps {

/// The image resampled to another size, each axis by its own factor s = new/old. A column c becomes
/// s(c + .5) − .5, because pixel areas are scaled, not pixel centres. The lens stays: it lives on the plane
/// z = 1.
CalibratedCamera resized(const CalibratedCamera& calibrated, int width, int height);

/// Left and right exchanged: cx → W − 1 − cx, and p2 changes its sign, because its terms are even in x.
CalibratedCamera mirrored_left_right(const CalibratedCamera& calibrated);

}  // namespace cps
