#pragma once

#include <OpenImageIO/imagebuf.h>

#include <vector>

#include "distortion/tile_rect.h"

namespace cps {

/// A rectangle of an image as float planes, one per channel. Rows are padded so that loads of eight pixels
/// stay inside the memory.
struct PlanarPatch {
  static constexpr int padding = 8;
  TileRect rect;
  int channels = 0;
  std::size_t stride = 0;
  std::vector<float> values;

  const float* row(int channel, int y) const {
    return &values[(std::size_t(channel) * rect.height + (y - rect.y0)) * stride];
  }
};

/// Copies a rectangle of an image held in memory, any pixel type (integers as fractions of their largest
/// value). Unchecked: the rectangle lies inside the image, which has 1–4 channels. `patch` keeps its memory
/// between calls.
void read_patch(const OIIO::ImageBuf& image, const TileRect& rect, PlanarPatch& patch);

}  // namespace cps
