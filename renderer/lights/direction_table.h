#pragma once

#include <cmath>
#include <vector>

#include "renderer/math/color.h"
#include "renderer/math/fast_math.h"

namespace cps {

/// How a table of directions spaces its rows between straight down and straight up.
enum class Rows {
  crowded_at_horizon,  ///< by √|y|: a clear sky varies most there
  even_in_elevation    ///< as in an equirectangular picture
};

/// The sphere of directions as a table: columns by azimuth about +y, starting at +x and turning to +z. Both
/// coordinates run over [0, 1].
inline Eigen::Vector2f table_coordinates(const Vec3& direction, Rows rows = Rows::crowded_at_horizon) {
  const float y = direction.y();
  const float from_horizon =
      rows == Rows::crowded_at_horizon
          ? 0.5f * std::sqrt(std::min(std::abs(y), 1.0f))
          : 2.0f * turns_of_vector(std::sqrt(direction.x() * direction.x() + direction.z() * direction.z()),
                                   std::abs(y));
  return {turns_of_vector(direction.x(), direction.z()), 0.5f + std::copysign(from_horizon, y)};
}

inline float elevation_sine_of_row(float row, Rows rows = Rows::crowded_at_horizon) {
  const float t = 2.0f * row - 1.0f;
  if (rows == Rows::crowded_at_horizon) return t * std::abs(t);
  return std::copysign(sincos_of_turns(0.25f * std::abs(t)).sin, t);
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

/// Draws directions in proportion to a table of weights; uniform by solid angle within a cell.
struct DirectionDistribution {
  int columns = 0, rows = 0;
  Rows spacing = Rows::crowded_at_horizon;
  std::vector<float> density;     ///< 1/sr, row by row
  std::vector<float> row_cdf;     ///< rows + 1 entries from 0 to 1
  std::vector<float> column_cdf;  ///< columns + 1 entries for every row

  /// True if all weights were 0: sample() may not be called.
  bool empty() const { return density.empty(); }
  float pdf(const Vec3& direction) const;  ///< 0 where it is empty
  DirectionSample sample(const Eigen::Vector2f& u) const;
};

/// `weights` ≥ 0 per solid angle, rows × columns; the distribution is empty if all are 0.
DirectionDistribution make_direction_distribution(int columns, int rows, Rows spacing,
                                                  const std::vector<float>& weights);

}  // namespace cps
