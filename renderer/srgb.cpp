#include "renderer/srgb.h"

#include <algorithm>
#include <cmath>

namespace cps {

const std::array<float, 256>& srgb_decode_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (int code = 0; code < 256; ++code) {
      const double v = code / 255.0;
      values[code] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
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
  const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

}  // namespace cps
