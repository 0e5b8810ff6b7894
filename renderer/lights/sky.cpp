#include "renderer/lights/sky.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cps {
namespace {

float sine_of_row_border(const Sky& sky, int row) {
  return elevation_sine_of_row(static_cast<float>(row) / static_cast<float>(sky.rows), sky.spacing);
}

/// Mean luminance of the distribution's cells, by the table's own interpolation, so that no bright spot lies
/// where hardly anything is drawn.
std::vector<float> mean_luminance(const Sky& sky, int columns, int rows) {
  std::vector<float> means(static_cast<std::size_t>(columns) * rows);
  const auto points_for = [](int table, int cells) { return std::max(4, 2 * ((table + cells - 1) / cells)); };
  const int across = points_for(sky.columns, columns), down = points_for(sky.rows, rows);
  tbb::parallel_for(0, rows, [&](int row) {
    for (int column = 0; column < columns; ++column) {
      float sum = 0;
      for (int i = 0; i < across * down; ++i) {
        const float x = (static_cast<float>(column) +
                         (static_cast<float>(i % across) + 0.5f) / static_cast<float>(across)) /
                        static_cast<float>(columns);
        const float y =
            (static_cast<float>(row) + (static_cast<float>(i / across) + 0.5f) / static_cast<float>(down)) /
            static_cast<float>(rows);
        sum += luminance(sky.radiance(direction_at(x, elevation_sine_of_row(y, sky.spacing))));
      }
      means[static_cast<std::size_t>(row) * columns + column] = sum / static_cast<float>(across * down);
    }
  });
  return means;
}

}  // namespace

Color Sky::radiance(const Vec3& direction) const {
  const Eigen::Vector2f at = table_coordinates(direction, spacing);
  const float x = at.x() * static_cast<float>(columns) - 0.5f;
  const float y = std::clamp(at.y() * static_cast<float>(rows) - 0.5f, 0.0f, static_cast<float>(rows - 1));
  const float floor_x = std::floor(x);
  const int column = static_cast<int>(floor_x), row = std::min(static_cast<int>(y), rows - 2);
  const int left = column < 0 ? columns - 1 : column, right = column + 1 < columns ? column + 1 : 0;
  const float fx = x - floor_x, fy = y - static_cast<float>(row);
  const Eigen::Array4f* low = &radiance_table[static_cast<std::size_t>(row) * columns];
  const Eigen::Array4f* high = low + columns;
  const Eigen::Array4f value = (low[left] * (1.0f - fx) + low[right] * fx) * (1.0f - fy) +
                               (high[left] * (1.0f - fx) + high[right] * fx) * fy;
  return value.head<3>();
}

Sky make_empty_sky(int columns, int rows, Rows spacing) {
  const std::size_t cells = static_cast<std::size_t>(columns) * rows;
  return {columns, rows, spacing, std::vector<Eigen::Array4f>(cells, Eigen::Array4f::Zero()), {}};
}

void set_cell(Sky& sky, int column, int row, const Color& radiance) {
  sky.radiance_table[static_cast<std::size_t>(row) * sky.columns + column] << radiance, 0.0f;
}

Vec3 cell_direction(const Sky& sky, int column, int row) {
  const float middle = (static_cast<float>(row) + 0.5f) / static_cast<float>(sky.rows);
  return direction_at((static_cast<float>(column) + 0.5f) / static_cast<float>(sky.columns),
                      elevation_sine_of_row(middle, sky.spacing));
}

Color horizontal_irradiance(const Sky& sky) {
  Color sum = Color::Zero();
  for (int row = sky.rows / 2; row < sky.rows; ++row) {
    const float low = sine_of_row_border(sky, row), high = sine_of_row_border(sky, row + 1);
    const float cosine_sr =
        std::numbers::pi_v<float> * (high * high - low * low) / static_cast<float>(sky.columns);
    for (int column = 0; column < sky.columns; ++column) {
      sum += cosine_sr * sky.radiance_table[static_cast<std::size_t>(row) * sky.columns + column].head<3>();
    }
  }
  return sum;
}

DirectionDistribution make_sky_distribution(const Sky& sky) {
  constexpr int min_cells = 64, max_columns = 512, max_rows = 256;
  const int columns = std::clamp(sky.columns / 4, min_cells, max_columns);
  const int rows = std::clamp(sky.rows / 4, min_cells, max_rows);
  std::vector<float> weights = mean_luminance(sky, columns, rows);
  double mean = 0;
  for (int row = 0; row < rows; ++row) {
    const float low = elevation_sine_of_row(static_cast<float>(row) / static_cast<float>(rows), sky.spacing);
    const float high =
        elevation_sine_of_row(static_cast<float>(row + 1) / static_cast<float>(rows), sky.spacing);
    for (int column = 0; column < columns; ++column)
      mean += weights[static_cast<std::size_t>(row) * columns + column] * (high - low) / (2.0 * columns);
  }
  // Do not draw what exceeds the mean by rounding alone.
  const auto left_to_bsdfs = static_cast<float>(1.0001 * mean);
  for (float& weight : weights) weight = std::max(0.0f, weight - left_to_bsdfs);
  return make_direction_distribution(columns, rows, sky.spacing, weights);
}

Sky make_constant_sky(const Color& radiance) {
  Sky sky = make_empty_sky(2, 2, Rows::crowded_at_horizon);
  for (int i = 0; i < 4; ++i) set_cell(sky, i % 2, i / 2, radiance);
  return sky;
}

}  // namespace cps
