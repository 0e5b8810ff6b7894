#pragma once

#include <torch/types.h>

#include <span>

#include "trainer/images/batches.h"
#include "trainer/images/pixel_statistics.h"

namespace cps {

/// The pixels, [n, 1, h, w] float, (pixel − mean) / deviation, flipped left to right where the image says so.
/// All images must have one size.
torch::Tensor image_tensor(std::span<const BatchImage> images, const PixelStatistics& statistics);

/// The unit of the size features.
inline constexpr ImageSize size_unit{.width = 3840, .height = 2160};

/// The size features, [n, 2] float: height and width of the original images, in size_unit.
torch::Tensor size_tensor(std::span<const BatchImage> images);

}  // namespace cps
