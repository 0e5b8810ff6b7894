#pragma once

#include <compare>

namespace cps {

struct ImageSize {
  int width = 0, height = 0;  ///< pixels
  auto operator<=>(const ImageSize&) const = default;
};

}  // namespace cps
