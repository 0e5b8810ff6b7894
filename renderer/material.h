#pragma once

#include <deque>
#include <vector>

#include "renderer/alpha_mask.h"
#include "renderer/mip_texture.h"
#include "scenes/scene.h"

namespace cps {

/// Texture coordinates of a hit in both sets, and the footprint it is seen with.
struct TextureFootprint {
  Eigen::Vector2f uv[2];
  float log2_width[2];  ///< log2 of the footprint's width, in units of each uv set
};

/// A texture as a material reads it.
struct TextureLookup {
  const MipTexture* texture = nullptr;  ///< null: none, reads as white
  int uv_set = 0;
  Eigen::Matrix<float, 2, 3> transform;
  float log2_texels_per_uv = 0;

  Eigen::Vector2f coordinates(const Eigen::Vector2f& uv) const {
    return transform.leftCols<2>() * uv + transform.col(2);
  }
  Eigen::Array4f sample(const TextureFootprint& at) const {
    if (!texture) return Eigen::Array4f::Ones();
    return texture->sample(coordinates(at.uv[uv_set]), at.log2_width[uv_set] + log2_texels_per_uv);
  }
};

/// glTF's material, ready for lookups.
struct SurfaceMaterial {
  Eigen::Array4f base_color;
  float metallic, roughness;
  Color emissive;
  TextureLookup base_color_texture, metallic_roughness_texture, normal_texture, emissive_texture;
  float normal_scale;
  AlphaMode alpha_mode;
  float alpha_cutoff;
  AlphaMask mask;  ///< of the base colour's alpha alone; texture is null where there is none
  bool double_sided;
  bool emits;
};

struct Materials {
  std::deque<MipTexture> textures;
  std::vector<SurfaceMaterial> surfaces;  ///< numbered as the scene's
};

/// Builds the mip pyramids and resolves the scene's materials. Throws std::runtime_error where an index, a
/// size or a number in the scene is off.
Materials make_materials(const Scene& scene);

}  // namespace cps
