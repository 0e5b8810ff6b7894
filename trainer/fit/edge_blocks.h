#pragma once

#include <vector>

#include "distortion/image_size.h"
#include "trainer/images/batches.h"

namespace cps {

/// The weighted tilts of a picture's edges, summed over the blocks of a grid: first those of near-vertical
/// edges, then those of near-horizontal ones, rows top to bottom.
struct EdgeBlocks {
  ImageSize picture;                 ///< at its own size
  ImageSize grid;                    ///< of blocks
  std::vector<float> weight;         ///< Σ w over a block's cells, edge_families × grid
  std::vector<float> weighted_tilt;  ///< Σ w · tilt
};

/// Cells of the orientation that make a block of the grid in which a network weighs edges, along each axis.
inline constexpr int cells_per_weight = 2;
/// Such blocks that make a block of the fit, along each axis.
inline constexpr int weights_per_block = 2;

/// The number of groups of `size` along an axis; the last may be smaller.
inline int groups_of(int count, int size) {
  return (count + size - 1) / size;
}

/// The grid in which a network weighs the edges of an image with this orientation grid, and the fit's.
ImageSize weight_grid(const ImageSize& orientation);
ImageSize fit_grid(const ImageSize& orientation);

/// The edges of an image as the network sees it, flipped if it says so, in its weight_grid(). A cell's weight
/// is its confidence squared, so a strong edge counts as at most one. The image must be measured.
EdgeBlocks measured_edges(const BatchImage& image);

/// The middle of each column and row of the fit's blocks, in half diagonals from the picture's middle.
struct BlockCentres {
  std::vector<double> x, y;
};
BlockCentres fit_block_centres(const ImageSize& picture, const ImageSize& orientation);

}  // namespace cps
