#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "trainer/images/gray_image.h"
#include "trainer/images/orientation/orientation.h"

namespace cps {

/// The structure tensor (Förstner, Gülch 1987) of one family of edges in one cell: sums over its gradients,
/// whose steep component is gx for near-vertical edges and gy for near-horizontal ones. Gradients are in
/// thirty-seconds of a gray level a pixel.
struct EdgeTensor {
  std::int64_t steep = 0;    ///< Σ of the steep component's square: the weight of the cell's tilt
  std::int64_t product = 0;  ///< Σ gx gy; product / steep is the mean tilt, weighted by the steep squares
  std::int64_t flat = 0;  ///< Σ of the other component's square; flat / steep is the mean square of the tilt
};

/// How well the edges of a cell agree: 1 / (1 + (d / .03)²), where d is the standard deviation of their
/// tilts. The edges of leaves, people and shadows lie in all directions; their mean tilt is near 0 and says
/// nothing of the lens. 1 without edges.
double coherence(const EdgeTensor& tensor);

/// The edges of a picture, in the cells of a grid.
struct EdgeCells {
  ImageSize picture, grid;
  std::array<std::vector<EdgeTensor>, edge_families> families;  ///< one tensor for each cell, row by row
  std::int64_t energy = 0;                                      ///< Σ gx² + gy² over all pixels
};

/// The cell of pixel `i` along an axis of so many pixels and cells: the one that holds the pixel's centre
/// (on a boundary: the right one).
inline int cell_of(int i, int pixels, int cells) {
  return static_cast<int>((2 * std::int64_t{i} + 1) * cells / (2 * std::int64_t{pixels}));
}

/// Gradients by Scharr's 3×3 operator (Scharr 2000) at all pixels but the outermost, summed over the cells of
/// `grid`. All in whole numbers, so neither order nor processor changes the result. A picture of fewer than
/// 3×3 pixels has no edges.
EdgeCells edge_cells(const GrayView& picture, const ImageSize& grid);

}  // namespace cps
