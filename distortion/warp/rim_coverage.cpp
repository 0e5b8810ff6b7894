#include "distortion/warp/rim_coverage.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "distortion/warp/pixel_bounds.h"

namespace cps {

bool is_rim_covered(const ViewFootprints& footprints, const Pinhole& view, const ImageSize& source) {
  constexpr int side = FootprintTile::side;
  const auto tile = std::make_unique<FootprintTile>();
  const auto is_covered = [&](const TileRect& rect) {
    footprints(view, rect, *tile);
    BoundsRow bounds;
    for (int row = 0; row < rect.height; ++row)
      if (find_bounds(*tile, row, source.width, source.height, bounds) > 0) return false;
    return true;
  };
  for (int x0 = 0; x0 < view.width; x0 += side) {
    const int width = std::min(side, view.width - x0);
    if (!is_covered({x0, 0, width, 1}) || !is_covered({x0, view.height - 1, width, 1})) return false;
  }
  for (int y0 = 0; y0 < view.height; y0 += side) {
    const int height = std::min(side, view.height - y0);
    if (!is_covered({0, y0, 1, height}) || !is_covered({view.width - 1, y0, 1, height})) return false;
  }
  return true;
}

Pinhole zoomed(const Pinhole& camera, double zoom) {
  Pinhole result = camera;
  result.fx *= zoom;
  result.fy *= zoom;
  return result;
}

double smallest_covered_zoom(const ViewFootprints& footprints, const Pinhole& view, const ImageSize& source,
                             double min_zoom) {
  const auto is_covered = [&](double zoom) { return is_rim_covered(footprints, zoomed(view, zoom), source); };
  if (is_covered(min_zoom)) return min_zoom;
  double low = min_zoom, high = 1.01 * min_zoom;
  while (!is_covered(high)) {
    low = high;
    high *= 1.05;
    if (high > 1000 * min_zoom) return std::numeric_limits<double>::infinity();
  }
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (is_covered(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace cps
