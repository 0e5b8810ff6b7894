#pragma once

#include <cstdint>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// RGBA, 8 bit, rows from the top, alpha not multiplied in.
struct DecodedImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Decodes PNG, JPEG and WebP (gray, gray + alpha, RGB, RGBA; 16 bit reduced to 8); refuses others by name.
DecodedImage decode_image(Document& document, int image);

}  // namespace cps::gltf
