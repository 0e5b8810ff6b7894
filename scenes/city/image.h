#pragma once

#include <cstdint>
#include <vector>

namespace cps::city {

/// 8-bit pixels, rows from the top, `channels` per pixel.
struct Image {
  int width = 0, height = 0, channels = 3;
  std::vector<std::uint8_t> pixels;
};

}  // namespace cps::city
