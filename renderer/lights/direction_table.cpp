#include "renderer/lights/direction_table.h"

#include <algorithm>
#include <numbers>

namespace cps {
namespace {

/// The step of a cumulative distribution that u falls into, and where within it. Steps of zero height are
/// never chosen.
struct Step {
  int index;
  float fraction;
};

Step find_step(const float* cdf, int steps, float u) {
  const float* above = std::upper_bound(cdf + 1, cdf + steps, u);
  const auto index = static_cast<int>(above - cdf) - 1;
  const float height = cdf[index + 1] - cdf[index];
  return {index, height > 0.0f ? std::min((u - cdf[index]) / height, 0x1.fffffep-1f) : 0.5f};
}

}  // namespace

float DirectionDistribution::pdf(const Vec3& direction) const {
  if (empty()) return 0.0f;
  const Eigen::Vector2f at = table_coordinates(direction, spacing);
  const int column = std::min(static_cast<int>(at.x() * static_cast<float>(columns)), columns - 1);
  const int row = std::min(static_cast<int>(at.y() * static_cast<float>(rows)), rows - 1);
  return density[row * columns + column];
}

DirectionSample DirectionDistribution::sample(const Eigen::Vector2f& u) const {
  const Step row = find_step(row_cdf.data(), rows, u.y());
  const Step column = find_step(&column_cdf[row.index * (columns + 1)], columns, u.x());
  const float low = elevation_sine_of_row(static_cast<float>(row.index) / static_cast<float>(rows), spacing);
  const float high =
      elevation_sine_of_row(static_cast<float>(row.index + 1) / static_cast<float>(rows), spacing);
  const float turns = (static_cast<float>(column.index) + column.fraction) / static_cast<float>(columns);
  return {direction_at(turns, low + row.fraction * (high - low)),
          density[row.index * columns + column.index]};
}

DirectionDistribution make_direction_distribution(int columns, int rows, Rows spacing,
                                                  const std::vector<float>& weights) {
  if (std::all_of(weights.begin(), weights.end(), [](float w) { return w == 0.0f; })) return {};
  DirectionDistribution result{columns, rows, spacing, weights, {}, {}};
  const auto accumulate = [](const std::vector<double>& masses, std::vector<float>& cdf) {
    double total = 0, sum = 0;
    for (double mass : masses) total += mass;
    cdf.push_back(0.0f);
    for (std::size_t i = 0; i < masses.size(); ++i) {
      sum += masses[i];
      const double even = static_cast<double>(i + 1) / static_cast<double>(masses.size());
      cdf.push_back(i + 1 == masses.size() ? 1.0f : static_cast<float>(total > 0 ? sum / total : even));
    }
    return total;
  };
  std::vector<double> row_masses;
  for (int row = 0; row < rows; ++row) {
    const double low = elevation_sine_of_row(static_cast<float>(row) / static_cast<float>(rows), spacing);
    const double high =
        elevation_sine_of_row(static_cast<float>(row + 1) / static_cast<float>(rows), spacing);
    const double cell_sr = (high - low) * 2.0 * std::numbers::pi / columns;
    std::vector<double> masses;
    for (int column = 0; column < columns; ++column)
      masses.push_back(result.density[row * columns + column] * cell_sr);
    row_masses.push_back(accumulate(masses, result.column_cdf));
  }
  const double total = accumulate(row_masses, result.row_cdf);
  for (float& density : result.density) density = static_cast<float>(density / total);
  return result;
}

}  // namespace cps
