#pragma once

#include <cstdint>
#include <vector>

#include "renderer/materials/mip_texture.h"

namespace cps {

/// Precomputed answer to whether a texture's filtered alpha reaches a threshold: for every square between
/// four texel centres, two bits say that all of it passes, that none does, or that the bilinear value
/// decides.
struct AlphaMask {
  const MipTexture* texture = nullptr;
  float threshold = 0.5f;
  std::vector<std::uint8_t> squares;  ///< four to a byte, rows of level 0

  /// Whether alpha at `uv` reaches the threshold. Unchecked: uv must be finite.
  bool passes(const Eigen::Vector2f& uv) const;
};

AlphaMask make_alpha_mask(const MipTexture& texture, float threshold);

}  // namespace cps
