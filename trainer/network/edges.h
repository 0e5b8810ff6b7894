#pragma once

#include <torch/types.h>

namespace cps {

/// Sobel's kernels, [2, 1, 3, 3]: slope to the right, slope downwards.
torch::Tensor sobel_kernels();

/// Adds an edge channel. images: [n, 1, h, w]. Returns [n, 2, h, w]: each image and the magnitude of its
/// gradient by Sobel's 3×3 operator (Sobel, Feldman 1968), per pixel. Pixels beyond the border repeat the
/// outermost ones. Mirrored images have mirrored edges.
torch::Tensor with_sobel_edges(const torch::Tensor& images);

}  // namespace cps
