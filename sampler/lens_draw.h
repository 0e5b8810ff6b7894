#pragma once

#include <array>
#include <optional>

#include "distortion/crop.h"
#include "distortion/interval.h"
#include "random/counter_hash.h"
#include "sampler/lens_options.h"

namespace cps {

/// A lens as drawn: its coefficients, the final camera its crop gives, and the interval each number came
/// from.
struct DrawnLens {
  Distortion distortion;
  Crop crop;
  /// In the order k1 k2 k3 p1 p2 cx cy. Empty for the undistorted lens, and for coefficients that were drawn
  /// jointly, from a prior.
  std::array<std::optional<Interval>, 7> limits;
};

/// A lens for images at `base`. First the coefficients, in units of the frame's half diagonal, so that they
/// know nothing of the H-FOV; then cx and cy, in random order, uniform inside the shifts that keep the crop's
/// zoom below its cap. Every lens is within options.bounds on the frame of `base`, certificate included. One
/// that is not, or whose crop exceeds the zoom cap or what the warp's oversampling carries, is drawn again as
/// a whole. Throws std::runtime_error when the options leave no lens.
DrawnLens draw_lens(const Pinhole& base, const LensOptions& options, Stream stream);

/// No distortion, centred principal point, zoom 1.
DrawnLens undistorted_lens(const Pinhole& base);

}  // namespace cps
