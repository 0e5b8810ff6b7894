#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/math/color.h"
#include "scenes/scene.h"

namespace cps {

/// A texture with its mip levels, 8 bits per channel in 4×4-texel tiles of one cache line. Colours are
/// decoded to linear light before they are averaged, down the levels and in every lookup.
struct MipTexture {
  struct Level {
    int width, height;
    std::size_t first_texel;
    int tiles_across;
  };

  std::vector<std::uint32_t> texels;  ///< RGBA, red in the lowest byte
  std::vector<Level> levels;          ///< level 0 is the image itself, the last is 1×1
  const float* decode;                ///< 256 entries: stored colour byte → linear
  Wrap wrap_u, wrap_v;
  bool nearest;

  /// Filtered RGBA, linear, at `uv`; trilinear between the levels around `level_of_detail` (log2 of the
  /// footprint's width in texels; 0 or less is the full image). A `nearest` texture returns a texel of the
  /// full image. Unchecked: uv must be finite.
  Eigen::Array4f sample(const Eigen::Vector2f& uv, float level_of_detail) const;

  /// RGBA of one texel of level 0, linear. Unchecked: x and y must be in range.
  Eigen::Array4f texel(int x, int y) const;
};

/// Builds the mip levels. `weigh_by_alpha`: transparent texels do not contribute their colour to averages, as
/// base colours need whose alpha cuts holes.
MipTexture make_mip_texture(const Texture& texture, bool weigh_by_alpha);

}  // namespace cps
