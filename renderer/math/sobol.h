#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "random/counter_hash.h"

/// Owen-scrambled Sobol points by hashing (Burley 2020, "Practical hash-based Owen scrambling"): no tables
/// and no state. High dimensions are padded: each pair of dimensions is the two-dimensional Sobol
/// (0,2)-sequence with an order and a scramble of its own.
namespace cps {

inline std::uint32_t reverse_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// A random permutation of 32-bit numbers in which each bit depends on lower bits only: on reversed digits
/// this is a nested uniform (Owen) scramble. Laine & Karras 2011, with the constants of Vegdahl 2021.
inline std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// The second Sobol coordinate of `index` with its digits reversed. Its matrix is Pascal's triangle modulo 2,
/// so read as a polynomial over GF(2) the index p(x) becomes p(x + 1): a Taylor shift in five steps. (The
/// first coordinate, reversed, is the index itself.)
inline std::uint32_t sobol_1_reversed(std::uint32_t index) {
  index ^= (index >> 16) & 0x0000ffffu;
  index ^= (index >> 8) & 0x00ff00ffu;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 2) & 0x33333333u;
  return index ^ ((index >> 1) & 0x55555555u);
}

/// 32 random bits → [0, 1), of which 24 are used.
inline float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// Columns of the third and fourth coordinate (upper and lower half) for each digit of an index below 2^16,
/// digits reversed. They are Pascal matrices over GF(4) with the entries C(j, i) ω^(j−i) and C(j, i) ω^2(j−i)
/// (Faure 1982), each element as a 2×2 matrix over GF(2), arranged so that both coordinates are a
/// (0,2)-sequence in base 2 by themselves as the first two are (Ahmed et al. 2024, "SZ sequences").
constexpr std::uint32_t faure_columns[16] = {
    0x00010001, 0x00020003, 0x00060006, 0x000b000d, 0x00130013, 0x00210032, 0x006d006d, 0x00b600db,
    0x01020102, 0x02030301, 0x060b060b, 0x0b0d0d06, 0x13211321, 0x21323213, 0x6db66db6, 0xb6dbdb6d};

/// The random numbers of one sample of one pixel, as pairs that may be asked for in any order.
struct SobolSample {
  std::uint64_t pixel_key;
  std::uint32_t index;

  /// Pair 0 or 1 of a four-dimensional sequence, uniform in [0, 1)²: the two together fill four dimensions
  /// evenly (each aligned 4^m samples of a pixel are an Owen-scrambled (0,m,4)-net in base 4), so that what
  /// depends on both converges faster than with padded pairs. For up to 2^16 samples.
  Eigen::Vector2f joint_pair(std::uint32_t which) const {
    const std::uint64_t seeds = mix64(pixel_key + 0xbf58476d1ce4e5b9ull * (which + 1));
    std::uint32_t x = index, y;
    if (which == 0) {
      y = sobol_1_reversed(index);
    } else {
      std::uint32_t both = 0;
      for (int digit = 0; index >> digit != 0; ++digit)
        both ^= faure_columns[digit] & (0u - (index >> digit & 1u));
      x = both >> 16, y = both & 0xffffu;
    }
    return {unit_float(reverse_bits(laine_karras(x, static_cast<std::uint32_t>(seeds)))),
            unit_float(reverse_bits(laine_karras(y, static_cast<std::uint32_t>(seeds >> 32))))};
  }

  /// Pair `set`, uniform in [0, 1)². Over the samples of a pixel each aligned power of two is an
  /// Owen-scrambled (0,m,2)-net.
  Eigen::Vector2f pair(std::uint32_t set) const {
    const std::uint64_t seeds = mix64(pixel_key + 0x9e3779b97f4a7c15ull * (set + 1));
    const auto order = static_cast<std::uint32_t>(seeds), scramble = static_cast<std::uint32_t>(seeds >> 32);
    const std::uint32_t shuffled = reverse_bits(laine_karras(reverse_bits(index), order));
    return {unit_float(reverse_bits(laine_karras(shuffled, scramble))),
            unit_float(reverse_bits(
                laine_karras(sobol_1_reversed(shuffled), scramble * 0x9e3779b1u + 0x85ebca6bu)))};
  }
};

/// Random numbers of sample `index` of pixel (x, y).
inline SobolSample make_sobol_sample(std::uint64_t seed, int x, int y, std::uint32_t index) {
  const std::uint64_t pixel =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) | static_cast<std::uint32_t>(x);
  return {mix64(mix64(seed + 0x9e3779b97f4a7c15ull) ^ mix64(pixel + 0xd1b54a32d192ed03ull)), index};
}

}  // namespace cps
