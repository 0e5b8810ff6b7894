#pragma once

#include <cmath>
#include <cstdint>

#include "random/counter_hash.h"
#include "renderer/math/color.h"

/// Cells of the light cache: cubes on grids that are fixed in the world, each for the surfaces of one
/// material that face about one direction.
namespace cps {

constexpr float finest_cell_m = 0.125f;

/// Side of a cell of level 0, 1, …, metres.
inline float cell_size_m(int level) {
  return std::ldexp(finest_cell_m, level);
}

/// Which of 26 directions (to the faces, edges and corners of a cube) a unit vector is about.
inline std::uint32_t facing_of(const Vec3& normal) {
  constexpr float sine = 0.38268343f;  // of 22.5°
  const auto sign = [](float x) { return x > sine ? 2u : x < -sine ? 0u : 1u; };
  return sign(normal.x()) + 3 * sign(normal.y()) + 9 * sign(normal.z());
}

/// The direction, unit length.
inline Vec3 facing_direction(std::uint32_t facing) {
  const auto sign = [](std::uint32_t digit) { return static_cast<float>(digit) - 1.0f; };
  return Vec3(sign(facing % 3), sign(facing / 3 % 3), sign(facing / 9)).normalized();
}

struct Cell {
  Eigen::Vector3i index;   ///< on its level's grid
  std::uint8_t level;      ///< see cell_size_m()
  std::uint8_t facing;     ///< see facing_of()
  bool is_far;             ///< for light that reaches other surfaces, not the camera
  std::uint32_t material;  ///< index into Materials::surfaces

  bool operator==(const Cell&) const = default;

  /// A number that tells it from others but for one chance in 2^64.
  std::uint64_t hash() const {
    const auto bits = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)); };
    const std::uint64_t face =
        std::uint64_t{material} << 16 | std::uint64_t{level} << 8 | std::uint64_t{is_far} << 7 | facing;
    const std::uint64_t level_ground = bits(index.x()) << 32 | bits(index.z());
    return mix64(mix64(level_ground + 0x9e3779b97f4a7c15ull) ^ (bits(index.y()) << 32 ^ face));
  }
};

/// Cells do not begin at round coordinates, where people put floors and walls.
inline const Vec3 cell_offset(0.3819660f, 0.2360680f, 0.1458980f);

inline Cell cell_at(const Vec3& position, int level, std::uint32_t facing, bool is_far,
                    std::uint32_t material) {
  const Vec3 scaled = position / cell_size_m(level) + cell_offset;
  return {scaled.array().floor().cast<int>(), static_cast<std::uint8_t>(level),
          static_cast<std::uint8_t>(facing), is_far, material};
}

/// The cell's corner with the smallest coordinates, metres.
inline Vec3 cell_corner(const Cell& cell) {
  return (cell.index.cast<float>() - cell_offset) * cell_size_m(cell.level);
}

}  // namespace cps
