#pragma once

#include <cmath>
#include <numbers>

#include "distortion/models/lens_model.h"
#include "random/counter_hash.h"

/// Random lenses of every family and random rays, each a pure function of stream and index.
namespace cps {

/// A lens of the family with this place in LensModel, from ranges wide enough to hold lenses that fold well
/// inside the angles that cameras see; one of eight sits on an end or in the middle of its family's range.
inline LensModel random_model(std::size_t family, Stream stream, std::uint64_t index) {
  const Stream s = substream(stream, index);
  const auto draw = [&](int i, double low, double high) { return random_uniform(s, i, low, high); };
  const auto either = [&](int i, double bound) { return draw(i, -bound, bound); };
  const bool is_special = index % 8 == 0;
  const double special = 0.5 * static_cast<double>(random_below(s, 20, 3));  // 0, ½ or 1
  const double strength = draw(21, 0, 1);                                    // most real lenses are weak
  switch (family) {
    case 0:
      return Distortion{strength * either(0, 0.6), strength * either(1, 0.5), strength * either(2, 0.3),
                        strength * either(3, 0.05), strength * either(4, 0.05)};
    case 1:
      return RationalLens{strength * either(0, 1),   strength * either(1, 0.6), strength * either(2, 0.3),
                          strength * either(3, 1),   strength * either(4, 0.6), strength * either(5, 0.3),
                          strength * either(6, .05), strength * either(7, .05)};
    case 2:
      return KannalaBrandt{strength * either(0, 0.2), strength * either(1, 0.1), strength * either(2, 0.05),
                           strength * either(3, 0.02)};
    case 3:
      return UnifiedSpherical{
          is_special ? special : draw(5, 0, 3),
          {strength * either(0, 0.6), strength * either(1, 0.5), strength * either(2, 0.3),
           strength * either(3, 0.05), strength * either(4, 0.05)}};
    case 4:
      return Eucm{is_special ? special : draw(0, 0, 1), draw(1, 0.2, 3)};
    default:
      return DoubleSphere{is_special ? 1 : draw(0, -0.95, 1), index % 16 == 0 ? special : draw(1, 0, 1)};
  }
}

/// The unit ray at an angle from the axis, in a random direction about it.
inline Eigen::Vector3d random_ray(Stream stream, std::uint64_t index, double angle_rad) {
  const double around = random_uniform(stream, index, 0, 2 * std::numbers::pi);
  return {std::sin(angle_rad) * std::cos(around), std::sin(angle_rad) * std::sin(around),
          std::cos(angle_rad)};
}

}  // namespace cps
