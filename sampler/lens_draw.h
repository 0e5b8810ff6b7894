#pragma once

#include <array>
#include <optional>

#include "distortion/crop.h"
#include "distortion/interval.h"
#include "distortion/limits.h"
#include "random/counter_hash.h"

namespace cps {

/// A lens as drawn: its coefficients, the final camera its crop gives, and the interval each number came
/// from.
struct DrawnLens {
  Distortion distortion;
  Crop crop;
  /// In the order k1 k2 k3 p1 p2 cx cy; empty for the undistorted lens.
  std::array<std::optional<Interval>, 7> limits;
};

/// The thesis' scheme: the five coefficients in random order, each uniform in the interval that root-finding
/// leaves it given those already drawn (one sweep of a Gibbs sampler on the convex set of valid lenses); then
/// cx and cy, in random order too, inside the shifts that keep the crop's zoom below its cap. Every lens it
/// returns is certified on `padded_master`, the part of the plane z = 1 that the padded master sees. A lens
/// whose crop exceeds the zoom cap or what the warp's oversampling carries is drawn again as a whole. Throws
/// std::runtime_error when the bounds leave no lens.
DrawnLens draw_lens(const Pinhole& base, const Eigen::AlignedBox2d& padded_master, const LensBounds& bounds,
                    const PrincipalPointBounds& principal_point_bounds, Stream stream);

/// No distortion, centred principal point, zoom 1.
DrawnLens undistorted_lens(const Pinhole& base);

}  // namespace cps
