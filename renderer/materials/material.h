#pragma once

#include <deque>
#include <vector>

#include "renderer/materials/alpha_mask.h"
#include "renderer/materials/bsdf.h"
#include "renderer/materials/mip_texture.h"
#include "scenes/scene.h"

namespace cps {

/// Texture coordinates of a hit in both sets, and the footprint it is seen with.
struct TextureFootprint {
  Eigen::Vector2f uv[2];
  float log2_width[2];  ///< log2 of the width that one lookup averages, in units of each uv set
  int taps = 1;         ///< lookups in a row that cover the footprint
  Eigen::Vector2f step[2] = {Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};  ///< from one to the next
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

/// glTF's material, ready for lookups. What most materials lack stands last.
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
  bool transmits;        ///< light passes straight through some of it
  bool unlit;            ///< shows its base colour, and takes no light
  float unlit_radiance;  ///< of white, kcd/m²

  float dielectric_f0;  ///< by its index of refraction
  float specular;
  Color specular_color;
  TextureLookup specular_texture, specular_color_texture;
  float clearcoat, clearcoat_roughness, clearcoat_normal_scale;
  TextureLookup clearcoat_texture, clearcoat_roughness_texture, clearcoat_normal_texture;
  float transmission;
  TextureLookup transmission_texture;
};

/// What the BSDF is made of, where a surface of this base colour (textures and vertex colours included) is
/// seen through `at`. The coat's normal and what passes straight are left to the caller.
BsdfParameters bsdf_parameters(const SurfaceMaterial& material, const Color& base_color,
                               const TextureFootprint& at);

struct Materials {
  std::deque<MipTexture> textures;
  std::vector<SurfaceMaterial> surfaces;  ///< numbered as the scene's
};

/// Builds the mip pyramids and resolves the scene's materials. Throws std::runtime_error where an index, a
/// size or a number in the scene is off. White of unlit materials has the radiance `unlit_white`.
Materials make_materials(const Scene& scene, float unlit_white);

}  // namespace cps
