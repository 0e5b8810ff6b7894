#include "distortion/warp/pixel_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The loops have no branches or calls, so that they compile to vector instructions.
namespace cps {

int find_bounds(const FootprintTile& tile, int row, int source_width, int source_height, BoundsRow& bounds) {
  const KernelRow& kernels = tile.kernels[row];
  const double *x = &tile.x[row * FootprintTile::side], *y = &tile.y[row * FootprintTile::side];
  const double last_x = source_width - 1, last_y = source_height - 1;
  const int count = tile.width;
  int missing = 0;
  for (int i = 0; i < count; ++i) {
    const double width = kernels.half_width[i], height = kernels.half_height[i];
    const double x0 = std::ceil(x[i] - width), x1 = std::floor(x[i] + width);
    const double y0 = std::ceil(y[i] - height), y1 = std::floor(y[i] + height);
    // NaN counts as outside. Positions too large for an int are not converted.
    const bool inside = (x0 >= 0) & (y0 >= 0) & (x1 <= last_x) & (y1 <= last_y);
    bounds.x0[i] = int(inside ? x0 : -1.0);
    bounds.y0[i] = int(inside ? y0 : -1.0);
    bounds.x1[i] = int(inside ? x1 : -1.0);
    bounds.y1[i] = int(inside ? y1 : -1.0);
    missing += inside ? 0 : 1;
  }
  return missing;
}

void find_noise_bounds(const FootprintTile& tile, int row, const WeightedKernelRow& noise,
                       const BoundsRow& picture, BoundsRow& bounds) {
  const KernelRow& kernels = noise.kernels;
  const double *x = &tile.x[row * FootprintTile::side], *y = &tile.y[row * FootprintTile::side];
  const int count = tile.width;
  for (int i = 0; i < count; ++i) {
    const double width = kernels.half_width[i], height = kernels.half_height[i];
    const bool wanted = (picture.x0[i] >= 0) & (noise.weight[i] > 0);
    const int x0 = int(wanted ? std::ceil(x[i] - width) : -1.0);
    const int y0 = int(wanted ? std::ceil(y[i] - height) : -1.0);
    const int x1 = int(wanted ? std::floor(x[i] + width) : -1.0);
    const int y1 = int(wanted ? std::floor(y[i] + height) : -1.0);
    // Rounding may move the edge of an ellipse beyond that of the picture's.
    bounds.x0[i] = wanted ? std::max(x0, picture.x0[i]) : -1;
    bounds.y0[i] = std::max(y0, picture.y0[i]);
    bounds.x1[i] = std::min(x1, picture.x1[i]);
    bounds.y1[i] = std::min(y1, picture.y1[i]);
  }
}

TileRect common_bounds(std::span<const BoundsRow> rows, int count) {
  constexpr int most = std::numeric_limits<int>::max();
  int x0 = most, y0 = most, x1 = -1, y1 = -1;
  for (const BoundsRow& bounds : rows)
    for (int i = 0; i < count; ++i) {
      const bool none = bounds.x0[i] < 0;
      x0 = std::min(x0, none ? most : bounds.x0[i]);
      y0 = std::min(y0, none ? most : bounds.y0[i]);
      x1 = std::max(x1, bounds.x1[i]);
      y1 = std::max(y1, bounds.y1[i]);
    }
  if (x1 < 0) return {};
  return {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

}  // namespace cps
