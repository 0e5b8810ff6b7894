#pragma once

#include <cstdint>
#include <functional>

namespace cps {

/// A square part of a picture, rendered by one thread. Its pixels are numbered along Morton's curve, so that
/// eight in a row are a block of 4×2.
struct Tile {
  static constexpr int side = 16, pixels = side * side;
  int x0, y0;
};

struct TilePixel {
  int x, y;
};

/// Pixel `index` of the tile, in picture coordinates; may lie beyond the picture's right or lower border.
inline TilePixel tile_pixel(const Tile& tile, int index) {
  TilePixel pixel{tile.x0, tile.y0};
  for (int bit = 0; bit < 4; ++bit) {
    pixel.x += (index >> (2 * bit) & 1) << bit;
    pixel.y += (index >> (2 * bit + 1) & 1) << bit;
  }
  return pixel;
}

/// Progress callback: called after every tile, by one thread at a time.
using TileProgress = std::function<void(int done, int total)>;

/// Runs `work` on every tile of a picture, in parallel, with denormals flushed to zero. Returns the CPU
/// seconds of all threads.
double for_each_tile(int width, int height, const std::function<void(const Tile&)>& work,
                     const TileProgress& progress = {});

}  // namespace cps
