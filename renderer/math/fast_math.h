#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

/// The transcendental functions of the inner loop as plain polynomials: fast, inlined, and with the same bits
/// on every machine (a C library may choose a variant by CPU).
namespace cps {

struct SinCos {
  float sin, cos;
};

/// Sine and cosine of a fraction of a turn in [0, 1], to 2e-7. Taylor polynomials on an eighth of a turn.
inline SinCos sincos_of_turns(float turns) {
  const int quarter = static_cast<int>(4.0f * turns + 0.5f);
  const float x = (turns - 0.25f * static_cast<float>(quarter)) * (2.0f * std::numbers::pi_v<float>);
  const float x2 = x * x;
  const float s =
      x * (1.0f + x2 * (-1.0f / 6 + x2 * (1.0f / 120 + x2 * (-1.0f / 5040 + x2 * (1.0f / 362880)))));
  const float c = 1.0f + x2 * (-0.5f + x2 * (1.0f / 24 + x2 * (-1.0f / 720 + x2 * (1.0f / 40320))));
  switch (quarter & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// Angle of (x, y) as a fraction of a turn in [0, 1), to 3e-7; 0 for the zero vector. Polynomial for atan on
/// [0, 1] by Hastings (1955), "Approximations for digital computers", sheet 11.
inline float turns_of_vector(float x, float y) {
  const float ax = std::abs(x), ay = std::abs(y);
  const float largest = std::max(ax, ay);
  if (largest == 0.0f) return 0.0f;
  const float t = std::min(ax, ay) / largest;
  const float t2 = t * t;
  float angle = t * (0.99997726f +
                     t2 * (-0.33262347f +
                           t2 * (0.19354346f + t2 * (-0.11643287f + t2 * (0.05265332f - t2 * 0.01172120f)))));
  angle *= 0.5f * std::numbers::inv_pi_v<float>;
  if (ay > ax) angle = 0.25f - angle;
  if (x < 0.0f) angle = 0.5f - angle;
  if (y < 0.0f) angle = 1.0f - angle;
  return angle < 1.0f ? angle : 0.0f;
}

/// Base-2 logarithm of a positive normal number, to 3e-6. With the mantissa m in [√½, √2), ln m = 2
/// artanh((m−1)/(m+1)).
inline float log2_of(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t above_sqrt2 = (bits & 0x007fffffu) > 0x003504f3u;
  const float exponent =
      static_cast<float>(static_cast<int>(bits >> 23) - 127 + static_cast<int>(above_sqrt2));
  const float m = std::bit_cast<float>((bits & 0x007fffffu) | (above_sqrt2 ? 0x3f000000u : 0x3f800000u));
  const float s = (m - 1.0f) / (m + 1.0f);
  const float s2 = s * s;
  return exponent + s * (2.88539008f + s2 * (0.96179669f + s2 * 0.57707802f));
}

}  // namespace cps
