#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// exp and log without branches, calls or tables: a loop over them compiles to vector instructions. Exact to
/// 2 units in the last place where stated; they do not look at their argument.
namespace cps {

namespace straight {
inline constexpr double ln2_high = 6.93147180369123816490e-01;  // ln 2, its last bits zero
inline constexpr double ln2_low = 1.90821492927058770002e-10;   // ln 2 − ln2_high
}  // namespace straight

/// exp(x), −700 ≤ x ≤ 700.
[[gnu::always_inline]] inline double straight_exp(double x) {
  constexpr double inverse_ln2 = 1.44269504088896338700e+00;
  // Adding 1.5 · 2⁵² rounds to a whole number n, which then stands in the sum's lowest bits.
  constexpr double rounding = 0x1.8p52;
  const double rounded = std::fma(x, inverse_ln2, rounding);
  const double n = rounded - rounding;
  const double r = std::fma(-n, straight::ln2_low, std::fma(-n, straight::ln2_high, x));
  // Taylor's series; |r| ≤ ln 2 / 2.
  double series = 1.0 / 6227020800;
  series = std::fma(series, r, 1.0 / 479001600);
  series = std::fma(series, r, 1.0 / 39916800);
  series = std::fma(series, r, 1.0 / 3628800);
  series = std::fma(series, r, 1.0 / 362880);
  series = std::fma(series, r, 1.0 / 40320);
  series = std::fma(series, r, 1.0 / 5040);
  series = std::fma(series, r, 1.0 / 720);
  series = std::fma(series, r, 1.0 / 120);
  series = std::fma(series, r, 1.0 / 24);
  series = std::fma(series, r, 1.0 / 6);
  series = std::fma(series, r, 0.5);
  series = std::fma(series, r, 1.0);
  series = std::fma(series, r, 1.0);
  const double power_of_2 = std::bit_cast<double>((std::bit_cast<std::uint64_t>(rounded) + 1023) << 52);
  return series * power_of_2;
}

/// log(x) of a positive normal number, not within 1/16 of 1, where the last digits would be lost.
[[gnu::always_inline]] inline double straight_log(double x) {
  // x = m · 2ⁿ, √½ ≤ m < √2. The exponent is taken as a whole number of biased bits and becomes a double by
  // standing in the lowest bits of 2⁵².
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  constexpr std::uint64_t mantissa_bits = 0x000fffffffffffff, two_to_52 = 0x4330000000000000;
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (one - root_half);
  const double n = std::bit_cast<double>((shifted >> 52) | two_to_52) - (0x1p52 + 1023);
  const double m = std::bit_cast<double>((shifted & mantissa_bits) + root_half);
  // log m = 2 artanh s, s = (m − 1)/(m + 1), |s| ≤ .172.
  const double s = (m - 1) / (m + 1), z = s * s;
  double series = 1.0 / 21;
  series = std::fma(series, z, 1.0 / 19);
  series = std::fma(series, z, 1.0 / 17);
  series = std::fma(series, z, 1.0 / 15);
  series = std::fma(series, z, 1.0 / 13);
  series = std::fma(series, z, 1.0 / 11);
  series = std::fma(series, z, 1.0 / 9);
  series = std::fma(series, z, 1.0 / 7);
  series = std::fma(series, z, 1.0 / 5);
  series = std::fma(series, z, 1.0 / 3);
  series = std::fma(series, z, 1.0);
  return std::fma(n, straight::ln2_high, std::fma(n, straight::ln2_low, 2 * s * series));
}

}  // namespace cps
