#pragma once

#include <OpenImageIO/imagebuf.h>

#include <vector>

#include "distortion/warp/footprints.h"

namespace cps {

/// A rectangle of an image as float planes, one per channel. Rows are padded so that loads of eight pixels
/// stay inside the memory.
struct PlanarPatch {
  TileRect rect;
  int channels = 0;
  std::size_t stride = 0;
  std::vector<float> values;

  const float* row(int channel, int y) const {
    return &values[(std::size_t(channel) * rect.height + (y - rect.y0)) * stride];
  }
};

/// Copies a rectangle of an image held in memory, any pixel type (integers as fractions of their largest
/// value). Unchecked: the rectangle lies inside the image. `patch` keeps its memory between calls.
void read_patch(const OIIO::ImageBuf& image, const TileRect& rect, PlanarPatch& patch);

/// The source pixels whose centres lie inside a footprint's bounding box.
struct PixelBounds {
  int x0, y0, x1, y1;  ///< inclusive
};
PixelBounds pixel_bounds(const FootprintTile& tile, int index);

/// Whether the whole footprint lies inside a source of this size; false if its ray misses the source.
bool is_footprint_inside(const FootprintTile& tile, int index, int width, int height);

/// Sets one output pixel's channels (up to four) to the kernel-weighted mean over its footprint. Unchecked:
/// the bounds lie inside the patch and contain at least one pixel centre of the ellipse.
void gather(const PlanarPatch& patch, const FootprintTile& tile, int index, const PixelBounds& bounds,
            float* pixel);

}  // namespace cps
