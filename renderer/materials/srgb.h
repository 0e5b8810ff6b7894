#pragma once

#include <array>
#include <cstdint>

namespace cps {

/// 8-bit sRGB → linear light.
const std::array<float, 256>& srgb_decode_table();

/// 8-bit data → [0, 1].
const std::array<float, 256>& data_decode_table();

/// Linear light in [0, 1] → the nearest 8-bit sRGB code.
std::uint8_t srgb_encode(float linear);

}  // namespace cps
