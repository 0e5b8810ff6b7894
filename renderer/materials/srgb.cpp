#include "renderer/materials/srgb.h"

#include <algorithm>
#include <cmath>

#include "numbers/srgb.h"

namespace cps {

const std::array<float, 256>& srgb_decode_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int code = 0; code < 256; ++code) values[code] = static_cast<float>(linear_from_srgb(code / 255.0));
    return values;
  }();
  return table;
}

const std::array<float, 256>& data_decode_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int code = 0; code < 256; ++code) values[code] = static_cast<float>(code / 255.0);
    return values;
  }();
  return table;
}

std::uint8_t srgb_encode(float linear) {
  const double v = std::clamp(linear, 0.0f, 1.0f);
  return static_cast<std::uint8_t>(std::lround(255.0 * srgb_from_linear(v)));
}

}  // namespace cps
