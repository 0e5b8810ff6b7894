#include "trainer/fit/edge_blocks.h"

#include <algorithm>
#include <cmath>

namespace cps {
namespace {

constexpr int cells_per_block = cells_per_weight * weights_per_block;

/// The middles of the groups along an axis of `pixels`, of which a half diagonal has `half_diagonal`.
std::vector<double> group_middles(int pixels, int cells, double half_diagonal) {
  std::vector<double> middles;
  for (int first = 0; first < cells; first += cells_per_block) {
    const int end = std::min(cells, first + cells_per_block);
    middles.push_back(((first + end) / (2.0 * cells) - .5) * pixels / half_diagonal);
  }
  return middles;
}

}  // namespace

ImageSize weight_grid(const ImageSize& orientation) {
  return {groups_of(orientation.width, cells_per_weight), groups_of(orientation.height, cells_per_weight)};
}

ImageSize fit_grid(const ImageSize& orientation) {
  const ImageSize weights = weight_grid(orientation);
  return {groups_of(weights.width, weights_per_block), groups_of(weights.height, weights_per_block)};
}

EdgeBlocks measured_edges(const BatchImage& image) {
  const ImageSize& cells = image.orientation.grid;
  const ImageSize grid = weight_grid(cells);
  const std::size_t blocks = static_cast<std::size_t>(grid.width) * grid.height,
                    plane = static_cast<std::size_t>(cells.width) * cells.height;
  EdgeBlocks sums{image.original, grid, std::vector<float>(edge_families * blocks),
                  std::vector<float>(edge_families * blocks)};
  const float tilt_unit = static_cast<float>((image.mirror ? -1 : 1) / tilt_steps_per_unit),
              confidence_unit = static_cast<float>(1 / confidence_steps_per_unit);
  for (int family = 0; family < edge_families; ++family) {
    const std::int8_t *tilt = image.orientation.planes + family * plane,
                      *confidence = tilt + edge_families * plane;
    for (int y = 0; y < cells.height; ++y)
      for (int x = 0; x < cells.width; ++x, ++tilt, ++confidence) {
        const float c = *confidence * confidence_unit, weight = c * c;
        const int column = image.mirror ? cells.width - 1 - x : x;
        const std::size_t block = family * blocks +
                                  static_cast<std::size_t>(y / cells_per_weight) * grid.width +
                                  column / cells_per_weight;
        sums.weight[block] += weight;
        sums.weighted_tilt[block] += weight * *tilt * tilt_unit;
      }
  }
  return sums;
}

BlockCentres fit_block_centres(const ImageSize& picture, const ImageSize& orientation) {
  const double half_diagonal = std::hypot(picture.width, picture.height) / 2;
  return {group_middles(picture.width, orientation.width, half_diagonal),
          group_middles(picture.height, orientation.height, half_diagonal)};
}

}  // namespace cps
