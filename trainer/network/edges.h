#pragma once

#include <torch/types.h>

namespace cps {

/// images: [n, 1, h, w]. Returns [n, 2, h, w]: the images, and beside each the length of its gradient by
/// Sobel's 3×3 operator (Sobel, Feldman 1968), per pixel; beyond the border the outermost pixels go on.
/// Mirrored images have mirrored edges.
torch::Tensor with_sobel_edges(const torch::Tensor& images);

}  // namespace cps
