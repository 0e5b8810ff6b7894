#pragma once

#include "trainer/calibration/targets.h"

/// The H-FOV that an image sees along its middle row through the radial part of its lens, with the principal
/// point in the middle, against the H-FOV of its label, 2·atan(W / 2fx). Strong barrel distortion lets an
/// image see much more than its label says (KITTI: 82 to 91° where the label is 70 to 75°), and what is to be
/// seen is what a network recognises.
namespace cps {

/// The ideal radius that a radial lens r(1 + k1 r² + k2 r⁴ + k3 r⁶) sends to `distorted` > 0. If the lens
/// folds before it reaches that radius, the radius where it folds; never more than four times `distorted`.
/// Both in one unit; k1 k2 k3: outputs 1 to 3 of `lens` for that unit.
struct IdealRadius {
  double radius = 0;
  double slope = 1;  ///< of the distorted radius there; 0 where the lens folds or the limit is reached
};
IdealRadius ideal_radius(const Outputs& lens, double distorted);

/// Half the width over half the diagonal of an image.
double half_width_share(int width, int height);

/// The H-FOV seen, radians, of apparent outputs, and the label's H-FOV of outputs in TargetSpace::seen.
double seen_from_label_fov(const Outputs& apparent, int width, int height);
double label_from_seen_fov(const Outputs& seen, int width, int height);

}  // namespace cps
