#pragma once

#include <torch/types.h>

#include <span>

#include "trainer/images/batches.h"
#include "trainer/images/pixel_statistics.h"

namespace cps {

/// [n, 1, h, w] float, (pixel − mean) / deviation. All images must have one size.
torch::Tensor image_tensor(std::span<const BatchImage> images, const PixelStatistics& statistics);

/// [n, 2] float: height/2160, width/3840 of the originals.
torch::Tensor size_tensor(std::span<const BatchImage> images);

}  // namespace cps
