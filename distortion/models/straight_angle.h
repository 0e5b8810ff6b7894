#pragma once

#include <cmath>
#include <numbers>

/// Angles, sines and cosines for single pixels: additions, multiplications, divisions and square roots only,
/// which every processor and every C library round alike.
namespace cps {

/// arctan(t) / t for 0 ≤ t ≤ 1, to 6 units in the last place.
[[gnu::always_inline]] inline double straight_arctan_ratio(double t) {
  // arctan t = 2 arctan(t / (1 + √(1 + t²))), twice, then Taylor's series for tangents up to tan(π/16).
  const double first = 1 / (1 + std::sqrt(1 + t * t)), half = t * first;
  const double second = 1 / (1 + std::sqrt(1 + half * half)), quarter = half * second;
  const double z = quarter * quarter, z2 = z * z, z4 = z2 * z2;
  const double c0 = 1 - z * (1.0 / 3), c2 = 1.0 / 5 - z * (1.0 / 7), c4 = 1.0 / 9 - z * (1.0 / 11);
  const double c6 = 1.0 / 13 - z * (1.0 / 15), c8 = 1.0 / 17 - z * (1.0 / 19),
               c10 = 1.0 / 21 - z * (1.0 / 23);
  const double series = (c0 + c2 * z2) + ((c4 + c6 * z2) + (c8 + c10 * z2) * z4) * z4;
  return 4 * (first * second) * series;
}

/// The angle between a direction and the axis z.
struct AxisAngle {
  double angle_rad;   ///< in [0, π]
  double per_across;  ///< angle_rad / across; its limit 1 / along on the axis itself
};

/// The angle of a direction with the components `across` ≥ 0 and `along` the axis, of any length that can be
/// squared. Unchecked: the direction is not that of −z.
[[gnu::always_inline]] inline AxisAngle angle_from_axis(double across, double along) {
  const double length = std::sqrt(across * across + along * along);
  // Half the angle from the nearer half of the axis: no cancellation, and no 0/0 on the axis.
  const double inverse = 1 / (length + std::abs(along)), tangent = across * inverse;
  const double per_across = 2 * inverse * straight_arctan_ratio(tangent), angle = across * per_across;
  if (along >= 0) return {angle, per_across};
  const double obtuse = std::numbers::pi - angle;
  return {obtuse, obtuse / across};
}

struct SineCosine {
  double sine, cosine;
};

/// Of an angle in radians between −100 and 100, to 2 units in the last place of 1.
[[gnu::always_inline]] inline SineCosine straight_sine_cosine(double angle_rad) {
  // Quarter turns are taken off exactly: π/2 is the sum of both numbers to twice the precision.
  constexpr double quarter_high = 1.57079632679489655800e+00, quarter_low = 6.12323399573676603587e-17;
  constexpr double rounding = 0x1.8p52;  // adding it rounds to a whole number
  const double turns = (angle_rad * (2 / std::numbers::pi) + rounding) - rounding;
  const double r = std::fma(-turns, quarter_low, std::fma(-turns, quarter_high, angle_rad));
  const double z = r * r;
  const double sine_series =
      1.0 / 362880 +
      z * (-1.0 / 39916800 + z * (1.0 / 6227020800 + z * (-1.0 / 1307674368000 + z / 355687428096000)));
  const double sine = r + r * z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * sine_series)));
  const double cosine_series =
      1.0 / 40320 +
      z * (-1.0 / 3628800 + z * (1.0 / 479001600 + z * (-1.0 / 87178291200 + z / 20922789888000)));
  const double cosine = 1 - z * (0.5 - z * (1.0 / 24 + z * (-1.0 / 720 + z * cosine_series)));
  const int quarter = static_cast<int>(turns) & 3;
  const double swapped_sine = quarter & 1 ? cosine : sine, swapped_cosine = quarter & 1 ? sine : cosine;
  return {quarter & 2 ? -swapped_sine : swapped_sine, (quarter + 1) & 2 ? -swapped_cosine : swapped_cosine};
}

}  // namespace cps
