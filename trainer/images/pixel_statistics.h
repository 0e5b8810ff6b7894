#pragma once

#include <span>

#include "trainer/images/gray_image.h"

namespace cps {

/// Mean and standard deviation of the 8-bit pixels of a training set, by which its images are normalised.
struct PixelStatistics {
  double mean = 0, deviation = 1;
};

/// Over all pixels of all images, of which there must be at least one. A deviation below 1e-3 becomes 1.
PixelStatistics pixel_statistics(std::span<const GrayView> images);

}  // namespace cps
