#pragma once

#include <OpenImageIO/imagebuf.h>

#include <span>
#include <vector>

#include "distortion/footprints.h"

namespace cps {

/// A rectangle of one image, or the same rectangle of several, as float planes, one per channel, of rows
/// padded so that eight-wide loads stay inside.
struct PlanarPatch {
  int x0 = 0, y0 = 0, width = 0, height = 0, channels = 0;
  std::size_t stride = 0;
  std::vector<float> values;

  const float* row(int channel, int y) const {
    return &values[(std::size_t(channel) * height + (y - y0)) * stride];
  }
};

/// Copies [x0, x0+width) × [y0, y0+height) of images held in memory, any pixel type (integers as fractions of
/// their largest value), one image's channels after the other's. Unchecked: the rectangle lies inside the
/// images, which have one size. `patch` keeps its memory between calls.
void read_patch(std::span<const OIIO::ImageBuf* const> images, int x0, int y0, int width, int height,
                PlanarPatch& patch);

/// Whole source pixels inside a footprint's bounding box.
struct PixelBounds {
  int x0, y0, x1, y1;  ///< inclusive
};
PixelBounds pixel_bounds(const FootprintTile& tile, int index);

/// Whether a source of this size holds the whole footprint. One whose ray misses the source has none.
bool is_footprint_inside(const FootprintTile& tile, int index, int width, int height);

/// Gathers all channels of one output pixel, 1–4 or twice as many: the kernel-weighted mean over its
/// footprint. Unchecked: the bounds lie inside the patch and hold at least one pixel centre of the ellipse.
void gather(const PlanarPatch& patch, const FootprintTile& tile, int index, const PixelBounds& bounds,
            float* pixel);

}  // namespace cps
