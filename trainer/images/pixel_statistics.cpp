#include "trainer/images/pixel_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cps {

PixelStatistics pixel_statistics(std::span<const GrayView> images) {
  std::uint64_t count = 0, sum = 0, squares = 0;  // integers: exact in any order
  for (const GrayView& image : images) {
    const std::size_t n = static_cast<std::size_t>(image.size.width) * image.size.height;
    count += n;
    for (std::size_t i = 0; i < n; ++i) {
      sum += image.pixels[i];
      squares += static_cast<std::uint64_t>(image.pixels[i]) * image.pixels[i];
    }
  }
  const double mean = static_cast<double>(sum) / count;
  const double deviation = std::sqrt(std::max(0.0, static_cast<double>(squares) / count - mean * mean));
  return {mean, deviation > 1e-3 ? deviation : 1};
}

}  // namespace cps
