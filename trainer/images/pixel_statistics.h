#pragma once

#include <span>

#include "trainer/images/gray_image.h"

namespace cps {

/// Mean and standard deviation of 8-bit pixels over a training set: what its images are normalised by.
struct PixelStatistics {
  double mean = 0, deviation = 1;
};

PixelStatistics pixel_statistics(std::span<const GrayView> images);

}  // namespace cps
