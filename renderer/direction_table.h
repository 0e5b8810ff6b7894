#pragma once

#include <cmath>
#include <vector>

#include "renderer/color.h"
#include "renderer/fast_math.h"

namespace cps {

/// The sphere of directions as a table: columns by azimuth about +y, rows by √|y| from straight down to
/// straight up, so that rows crowd at the horizon. Both coordinates run over [0, 1].
inline Eigen::Vector2f table_coordinates(const Vec3& direction) {
  const float y = direction.y();
  return {turns_of_vector(direction.x(), direction.z()),
          0.5f + std::copysign(0.5f * std::sqrt(std::min(std::abs(y), 1.0f)), y)};
}

inline float elevation_sine_of_row(float row) {
  const float t = 2.0f * row - 1.0f;
  return t * std::abs(t);
}

inline Vec3 direction_at(float turns, float y) {
  const SinCos azimuth = sincos_of_turns(turns);
  const float horizontal = std::sqrt(std::max(0.0f, 1.0f - y * y));
  return {horizontal * azimuth.cos, y, horizontal * azimuth.sin};
}

struct DirectionSample {
  Vec3 direction;
  float pdf;  ///< 1/sr
};

/// Directions drawn in proportion to a table of weights; uniform by solid angle within a cell.
struct DirectionDistribution {
  int columns = 0, rows = 0;
  std::vector<float> density;     ///< 1/sr, row by row
  std::vector<float> row_cdf;     ///< rows + 1 entries from 0 to 1
  std::vector<float> column_cdf;  ///< columns + 1 entries for every row

  float pdf(const Vec3& direction) const;
  DirectionSample sample(const Eigen::Vector2f& u) const;
};

/// `weights` ≥ 0 per solid angle, rows × columns; all zero counts as all equal.
DirectionDistribution make_direction_distribution(int columns, int rows, const std::vector<float>& weights);

}  // namespace cps
