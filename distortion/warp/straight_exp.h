#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// exp and log without branches, calls or tables: a loop over them compiles to vector instructions. Exact to
/// 2 units in the last place for the arguments stated, which are not checked.
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
  // Taylor's series, |r| ≤ ln 2 / 2, by pairs (Estrin 1960): the shorter chain of operations is faster.
  const double r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
  const double c0 = 1 + r, c2 = std::fma(r, 1.0 / 6, 0.5);
  const double c4 = std::fma(r, 1.0 / 120, 1.0 / 24), c6 = std::fma(r, 1.0 / 5040, 1.0 / 720);
  const double c8 = std::fma(r, 1.0 / 362880, 1.0 / 40320), c10 = std::fma(r, 1.0 / 39916800, 1.0 / 3628800);
  const double c12 = std::fma(r, 1.0 / 6227020800, 1.0 / 479001600);
  const double low = std::fma(std::fma(c6, r2, c4), r4, std::fma(c2, r2, c0));
  const double high = std::fma(c12, r4, std::fma(c10, r2, c8));
  const double series = std::fma(high, r8, low);
  const double power_of_2 = std::bit_cast<double>((std::bit_cast<std::uint64_t>(rounded) + 1023) << 52);
  return series * power_of_2;
}

/// log(x) of a positive normal number. Within 1/16 of 1 only the absolute error is as small.
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
  const double z2 = z * z, z4 = z2 * z2, z8 = z4 * z4;
  const double c0 = std::fma(z, 1.0 / 3, 1.0), c2 = std::fma(z, 1.0 / 7, 1.0 / 5);
  const double c4 = std::fma(z, 1.0 / 11, 1.0 / 9), c6 = std::fma(z, 1.0 / 15, 1.0 / 13);
  const double c8 = std::fma(z, 1.0 / 19, 1.0 / 17), c10 = 1.0 / 21;
  const double low = std::fma(std::fma(c6, z2, c4), z4, std::fma(c2, z2, c0));
  const double series = std::fma(std::fma(c10, z2, c8), z8, low);
  return std::fma(n, straight::ln2_high, std::fma(n, straight::ln2_low, 2 * s * series));
}

}  // namespace cps
