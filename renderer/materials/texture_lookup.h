#pragma once

#include "renderer/materials/mip_texture.h"

namespace cps {

/// Texture coordinates of a hit in both uv sets, and the footprint that a lookup there averages over.
struct TextureFootprint {
  Eigen::Vector2f uv[2];
  float log2_width[2];  ///< log2 of the width that one lookup averages, in units of each set
  int taps = 1;         ///< number of lookups in a row that cover the footprint
  Eigen::Vector2f step[2] = {Eigen::Vector2f::Zero(),
                             Eigen::Vector2f::Zero()};  ///< from one lookup to the next
};

/// A texture as a material reads it.
struct TextureLookup {
  const MipTexture* texture = nullptr;  ///< null: reads as white
  int uv_set = 0;
  Eigen::Matrix<float, 2, 3> transform;
  float log2_texels_per_uv = 0;

  /// `uv` after KHR_texture_transform.
  Eigen::Vector2f coordinates(const Eigen::Vector2f& uv) const {
    return transform.leftCols<2>() * uv + transform.col(2);
  }
  /// Mean RGBA over the footprint, linear.
  Eigen::Array4f sample(const TextureFootprint& at) const {
    if (!texture) return Eigen::Array4f::Ones();
    const float level = at.log2_width[uv_set] + log2_texels_per_uv;
    if (at.taps == 1) return texture->sample(coordinates(at.uv[uv_set]), level);
    Eigen::Array4f sum = Eigen::Array4f::Zero();
    for (int tap = 0; tap < at.taps; ++tap) {
      const float steps = static_cast<float>(tap) - 0.5f * static_cast<float>(at.taps - 1);
      sum += texture->sample(coordinates(at.uv[uv_set] + steps * at.step[uv_set]), level);
    }
    return sum / static_cast<float>(at.taps);
  }
};

}  // namespace cps
