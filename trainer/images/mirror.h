#pragma once

#include "trainer/calibration/targets.h"

namespace cps {

/// The calibration of the image flipped left to right. The pixel at x goes to W−1−x, so cx does too; the two
/// terms of p2 in x_d do not change sign with x, so p2 does; everything else stays. Exact: it is the one
/// geometric augmentation whose label needs no crop.
Calibration mirrored(const Calibration& calibration);

}  // namespace cps
