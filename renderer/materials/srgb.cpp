#include "renderer/materials/srgb.h"

#include <algorithm>
#include <cmath>

namespace cps {

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

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
