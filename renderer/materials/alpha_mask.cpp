#include "renderer/materials/alpha_mask.h"

#include "renderer/materials/texture_wrap.h"

namespace cps {
namespace {

enum Square : std::uint8_t { none_passes, all_pass, mixed };

std::size_t square_index(const MipTexture::Level& level, int x, int y) {
  return static_cast<std::size_t>(y) * level.width + x;
}

}  // namespace

bool AlphaMask::passes(const Eigen::Vector2f& uv) const {
  const MipTexture::Level& level = texture->levels[0];
  std::size_t index;
  if (texture->nearest) {
    index = square_index(level, nearest_texel(uv.x(), level.width, texture->wrap_u),
                         nearest_texel(uv.y(), level.height, texture->wrap_v));
  } else {
    // A square is numbered by its texel of lower coordinates. Past an edge the wrap repeats or folds, so the
    // first neighbour still gives its number, except at the seam of `repeat`, where the last texel does.
    index = square_index(level, texel_pair(uv.x(), level.width, texture->wrap_u).first,
                         texel_pair(uv.y(), level.height, texture->wrap_v).first);
  }
  const int square = squares[index >> 2] >> (2 * (index & 3)) & 3;
  return square == mixed ? texture->sample(uv, 0.0f).w() >= threshold : square == all_pass;
}

AlphaMask make_alpha_mask(const MipTexture& texture, float threshold) {
  AlphaMask mask{&texture, threshold, {}};
  const MipTexture::Level& level = texture.levels[0];
  mask.squares.resize((static_cast<std::size_t>(level.width) * level.height + 3) / 4);
  const auto passes = [&](int x, int y) { return texture.texel(x, y).w() >= threshold; };
  const auto next = [](int i, int size, Wrap wrap) {
    return i + 1 < size ? i + 1 : wrap == Wrap::repeat ? 0 : i;
  };
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) {
      const int x1 = texture.nearest ? x : next(x, level.width, texture.wrap_u);
      const int y1 = texture.nearest ? y : next(y, level.height, texture.wrap_v);
      int passing = passes(x, y) + passes(x1, y) + passes(x, y1) + passes(x1, y1);
      // Below a clamped or mirrored edge (x.first = 0 stands for −1 too) all four are one row or column of
      // these, so "all" and "none" hold there as well.
      const Square square = passing == 4 ? all_pass : passing == 0 ? none_passes : mixed;
      const std::size_t index = square_index(level, x, y);
      mask.squares[index >> 2] |= static_cast<std::uint8_t>(square << (2 * (index & 3)));
    }
  }
  return mask;
}

}  // namespace cps
