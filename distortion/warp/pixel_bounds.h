#pragma once

#include <array>
#include <span>

#include "distortion/tile_rect.h"
#include "distortion/warp/footprints.h"
#include "distortion/warp/noise_kernels.h"

namespace cps {

/// For each pixel of a row, the source pixels whose centres lie inside the bounding box of its kernel: first
/// and last. x0 = −1: nothing is to be gathered.
struct BoundsRow {
  alignas(32) std::array<int, KernelRow::side> x0, y0, x1, y1;
};

/// Bounds of a row of footprints. x0 = −1 where a footprint leaves a source of this size or its ray misses
/// it; returns how many do.
int find_bounds(const FootprintTile& tile, int row, int source_width, int source_height, BoundsRow& bounds);

/// Bounds of the kernels that add noise to the same row, which lie inside those of the picture, `picture`.
/// x0 = −1 where the weight is 0 or the picture has none.
void find_noise_bounds(const FootprintTile& tile, int row, const WeightedKernelRow& noise,
                       const BoundsRow& picture, BoundsRow& bounds);

/// The smallest rectangle that holds the bounds of all rows, each `count` pixels wide; empty if nothing is to
/// be gathered.
TileRect common_bounds(std::span<const BoundsRow> rows, int count);

}  // namespace cps
