#include "renderer/materials/mip_texture.h"

#include <algorithm>
#include <cmath>

#include "renderer/materials/srgb.h"
#include "renderer/materials/texture_wrap.h"

namespace cps {
namespace {

constexpr int tile = 4;

std::size_t texel_index(const MipTexture::Level& level, int x, int y) {
  const auto tile_index = static_cast<std::size_t>(y / tile) * level.tiles_across + x / tile;
  return level.first_texel + tile_index * (tile * tile) + (y % tile) * tile + x % tile;
}

Eigen::Array4f decoded(const MipTexture& texture, std::uint32_t rgba) {
  return {texture.decode[rgba & 255], texture.decode[(rgba >> 8) & 255], texture.decode[(rgba >> 16) & 255],
          static_cast<float>(rgba >> 24) * (1.0f / 255.0f)};
}

Eigen::Array4f bilinear(const MipTexture& texture, const MipTexture::Level& level,
                        const Eigen::Vector2f& uv) {
  const TexelPair x = texel_pair(uv.x(), level.width, texture.wrap_u);
  const TexelPair y = texel_pair(uv.y(), level.height, texture.wrap_v);
  const auto at = [&](int tx, int ty) {
    return decoded(texture, texture.texels[texel_index(level, tx, ty)]);
  };
  const Eigen::Array4f top = at(x.first, y.first) * (1.0f - x.fraction) + at(x.second, y.first) * x.fraction;
  const Eigen::Array4f bottom =
      at(x.first, y.second) * (1.0f - x.fraction) + at(x.second, y.second) * x.fraction;
  return top * (1.0f - y.fraction) + bottom * y.fraction;
}

/// A level in linear light while the pyramid is built.
struct Plane {
  int width, height;
  std::vector<Eigen::Array4f> rgba;
};

/// Halves one axis. Each new texel is the mean of what it covers, so that odd sizes lose nothing. `at(i)`
/// reads and `put(i, v)` writes along the axis.
template <class At, class Put>
void halve_line(int size, int new_size, At at, Put put) {
  const float ratio = static_cast<float>(size) / static_cast<float>(new_size);
  for (int i = 0; i < new_size; ++i) {
    const float begin = static_cast<float>(i) * ratio, end = static_cast<float>(i + 1) * ratio;
    Eigen::Array4f sum = Eigen::Array4f::Zero();
    for (int j = static_cast<int>(begin); j < size && static_cast<float>(j) < end; ++j) {
      const float covered = std::min(end, static_cast<float>(j + 1)) - std::max(begin, static_cast<float>(j));
      if (covered > 0.0f) sum += covered * at(j);
    }
    put(i, sum / ratio);
  }
}

Plane halved(const Plane& source) {
  Plane across{std::max(1, source.width / 2), source.height, {}};
  across.rgba.resize(static_cast<std::size_t>(across.width) * across.height);
  for (int y = 0; y < source.height; ++y) {
    const Eigen::Array4f* from = &source.rgba[static_cast<std::size_t>(y) * source.width];
    Eigen::Array4f* to = &across.rgba[static_cast<std::size_t>(y) * across.width];
    halve_line(
        source.width, across.width, [&](int x) { return from[x]; },
        [&](int x, const Eigen::Array4f& v) { to[x] = v; });
  }
  Plane result{across.width, std::max(1, source.height / 2), {}};
  result.rgba.resize(static_cast<std::size_t>(result.width) * result.height);
  for (int x = 0; x < across.width; ++x) {
    halve_line(
        across.height, result.height,
        [&](int y) { return across.rgba[static_cast<std::size_t>(y) * across.width + x]; },
        [&](int y, const Eigen::Array4f& v) {
          result.rgba[static_cast<std::size_t>(y) * result.width + x] = v;
        });
  }
  return result;
}

std::uint32_t packed(const Eigen::Array4f& rgba, bool srgb, bool weighed_by_alpha) {
  const auto to_byte = [](float v) {
    return static_cast<std::uint32_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f);
  };
  const Eigen::Array4f v = weighed_by_alpha && rgba.w() > 0.0f ? Eigen::Array4f(rgba / rgba.w()) : rgba;
  std::uint32_t bits = to_byte(rgba.w()) << 24;
  for (int c = 0; c < 3; ++c) bits |= (srgb ? srgb_encode(v[c]) : to_byte(v[c])) << (8 * c);
  return bits;
}

MipTexture::Level append_level(MipTexture& texture, int width, int height) {
  const MipTexture::Level level{width, height, texture.texels.size(), (width + tile - 1) / tile};
  const auto tiles = static_cast<std::size_t>(level.tiles_across) * ((height + tile - 1) / tile);
  texture.texels.resize(texture.texels.size() + tiles * tile * tile);
  texture.levels.push_back(level);
  return level;
}

}  // namespace

Eigen::Array4f MipTexture::texel(int x, int y) const {
  return decoded(*this, texels[texel_index(levels[0], x, y)]);
}

Eigen::Array4f MipTexture::sample(const Eigen::Vector2f& uv, float level_of_detail) const {
  if (nearest) {
    return texel(nearest_texel(uv.x(), levels[0].width, wrap_u),
                 nearest_texel(uv.y(), levels[0].height, wrap_v));
  }
  const auto last = static_cast<float>(levels.size() - 1);
  const float lod = std::clamp(level_of_detail, 0.0f, last);
  const int level = static_cast<int>(lod);
  const float fraction = lod - static_cast<float>(level);
  const Eigen::Array4f fine = bilinear(*this, levels[level], uv);
  if (fraction == 0.0f) return fine;
  return fine + fraction * (bilinear(*this, levels[level + 1], uv) - fine);
}

MipTexture make_mip_texture(const Texture& source, bool weigh_by_alpha) {
  MipTexture texture;
  texture.decode = (source.srgb ? srgb_decode_table() : data_decode_table()).data();
  texture.wrap_u = source.wrap_u;
  texture.wrap_v = source.wrap_v;
  texture.nearest = source.nearest;

  Plane plane{source.width, source.height, {}};
  plane.rgba.resize(static_cast<std::size_t>(source.width) * source.height);
  const MipTexture::Level base = append_level(texture, source.width, source.height);
  for (int y = 0; y < source.height; ++y) {
    for (int x = 0; x < source.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * source.width + x;
      const std::uint8_t* in = &source.rgba[4 * i];
      const std::uint32_t bits = in[0] | in[1] << 8 | in[2] << 16 | static_cast<std::uint32_t>(in[3]) << 24;
      texture.texels[texel_index(base, x, y)] = bits;
      plane.rgba[i] = decoded(texture, bits);
      if (weigh_by_alpha) plane.rgba[i].head<3>() *= plane.rgba[i].w();
    }
  }
  while (!source.nearest && (plane.width > 1 || plane.height > 1)) {
    plane = halved(plane);
    const MipTexture::Level level = append_level(texture, plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y) {
      for (int x = 0; x < plane.width; ++x) {
        texture.texels[texel_index(level, x, y)] =
            packed(plane.rgba[static_cast<std::size_t>(y) * plane.width + x], source.srgb, weigh_by_alpha);
      }
    }
  }
  return texture;
}

}  // namespace cps
