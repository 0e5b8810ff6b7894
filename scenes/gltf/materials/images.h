#pragma once

#include <cstdint>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// RGBA, 8 bit, rows from the top, straight (not premultiplied) alpha.
struct DecodedImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Decodes a PNG, JPEG or WebP image of 1 to 4 channels; 16 bit becomes 8. Refuses other formats by name.
DecodedImage decode_image(Document& document, int image);

}  // namespace cps::gltf
