#pragma once

#include <optional>

#include "distortion/brown_conrady.h"
#include "random/counter_hash.h"

/// A prior over the lenses of cameras, in units of the frame's half diagonal: displacement of the corner, and
/// shape of the radial curve up to it. The ratios b and c cover those of KITTI's cameras (Geiger et al. 2013)
/// and of the photographic lenses in the Lensfun database.
namespace cps {

/// A radial lens: the point at radius r moves by K1 (r³ + b r⁵ + c r⁷), and K1 (1 + b + c) = corner.
struct LensShape {
  double corner = 0;  ///< displacement of the corner, r = 1; negative is barrel
  double b = 0, c = 0;
};

/// corner ~ U[−.33, .20], b ~ N(−.35, .35), c ~ N(−.1 b, .15).
LensShape draw_shape(Stream stream);

/// The coefficients of a shape; empty if |1 + b + c| < .25, where only a huge K1 moves the corner.
std::optional<Distortion> radial_lens(const LensShape& shape);

}  // namespace cps
