#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

/// Every random number in this project is a pure function of (seed, stream name, index). No generator has a
/// state: any thread may ask for any index in any order and gets the same number.
namespace cps {

/// 64-bit finaliser with full avalanche (Stafford 2011, variant 13: the one SplitMix64 uses).
constexpr std::uint64_t mix64(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// A named sequence of random numbers.
struct Stream {
  std::uint64_t key;
};

/// The stream `name` of `seed`. Every seed is valid, 0 included.
constexpr Stream make_stream(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = mix64(seed + 0x9e3779b97f4a7c15ull);
  for (char c : name) hash = mix64(hash ^ static_cast<unsigned char>(c)) + 0x9e3779b97f4a7c15ull;
  return {mix64(hash)};
}

/// The stream of the `index`-th thing drawn from `parent` (a lens, a building, a view).
constexpr Stream substream(Stream parent, std::uint64_t index) {
  return {mix64(mix64(parent.key + 0xd1b54a32d192ed03ull * (index + 1)) ^ parent.key)};
}

/// 64 uniform bits.
constexpr std::uint64_t random_bits(Stream stream, std::uint64_t index) {
  return mix64(mix64(stream.key ^ 0x2545f4914f6cdd1dull) + 0x9e3779b97f4a7c15ull * (index + 1));
}

/// Uniform in [0, 1), 53 bits.
constexpr double random_uniform(Stream stream, std::uint64_t index) {
  return static_cast<double>(random_bits(stream, index) >> 11) * 0x1p-53;
}

/// Uniform in [low, high).
constexpr double random_uniform(Stream stream, std::uint64_t index, double low, double high) {
  return low + (high - low) * random_uniform(stream, index);
}

/// Uniform integer in [0, count); count > 0.
constexpr std::uint64_t random_below(Stream stream, std::uint64_t index, std::uint64_t count) {
  return static_cast<std::uint64_t>((static_cast<unsigned __int128>(random_bits(stream, index)) * count) >>
                                    64);
}

/// Standard normal (Box & Muller 1958), from two numbers of substream(stream, index).
inline double random_normal(Stream stream, std::uint64_t index) {
  const Stream pair = substream(stream, index);
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random_uniform(pair, 0)));
  return radius * std::cos(2.0 * std::numbers::pi * random_uniform(pair, 1));
}

}  // namespace cps
