#pragma once

namespace cps {

/// A rectangle of whole pixels of an image: columns x0 … x0+width−1, rows y0 … y0+height−1.
struct TileRect {
  int x0 = 0, y0 = 0, width = 0, height = 0;
};

}  // namespace cps
