#pragma once

#include <cstdint>
#include <vector>

#include "renderer/materials/mip_texture.h"

namespace cps {

/// Where a texture's filtered alpha reaches a threshold, known beforehand: for every square between four
/// texel centres two bits say whether all of it passes, none of it, or the bilinear value must be looked at.
struct AlphaMask {
  const MipTexture* texture = nullptr;
  float threshold = 0.5f;
  std::vector<std::uint8_t> squares;  ///< four to a byte, rows of level 0

  /// Unchecked: uv must be finite.
  bool passes(const Eigen::Vector2f& uv) const;
};

AlphaMask make_alpha_mask(const MipTexture& texture, float threshold);

}  // namespace cps
