#pragma once

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "distortion/tile_rect.h"
#include "distortion/warp/footprints.h"

namespace cps {

/// Calls body(rect) once for each tile of an image, in parallel; a tile is at most FootprintTile::side wide
/// and high.
template <typename Body>
void for_each_tile(int width, int height, const Body& body) {
  constexpr int side = FootprintTile::side;
  const tbb::blocked_range2d<int> tiles(0, (height + side - 1) / side, 1, 0, (width + side - 1) / side, 1);
  tbb::parallel_for(
      tiles,
      [&](const tbb::blocked_range2d<int>& range) {
        for (int row = range.rows().begin(); row < range.rows().end(); ++row)
          for (int column = range.cols().begin(); column < range.cols().end(); ++column) {
            const int x0 = column * side, y0 = row * side;
            body(TileRect{x0, y0, std::min(side, width - x0), std::min(side, height - y0)});
          }
      },
      tbb::simple_partitioner());
}

}  // namespace cps
