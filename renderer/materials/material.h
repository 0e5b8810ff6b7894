#pragma once

#include <deque>
#include <vector>

#include "renderer/materials/alpha_mask.h"
#include "renderer/materials/bsdf.h"
#include "renderer/materials/texture_lookup.h"
#include "scenes/scene.h"

namespace cps {

/// glTF's material, with textures resolved. Members of rare extensions come last, out of the way of the
/// cache.
struct SurfaceMaterial {
  Eigen::Array4f base_color;
  float metallic, roughness;
  Color emissive;
  TextureLookup base_color_texture, metallic_roughness_texture, normal_texture, emissive_texture;
  float normal_scale;
  AlphaMode alpha_mode;
  float alpha_cutoff;
  AlphaMask mask;  ///< of the base colour texture's alpha; its texture is null if there is none
  bool double_sided;
  bool emits;
  bool transmits;        ///< some light passes straight through
  bool unlit;            ///< shows its base colour and reflects nothing
  float unlit_radiance;  ///< of white, kcd/m²

  float dielectric_f0;  ///< reflectance at normal incidence, by the index of refraction
  float specular;
  Color specular_color;
  TextureLookup specular_texture, specular_color_texture;
  float clearcoat, clearcoat_roughness, clearcoat_normal_scale;
  TextureLookup clearcoat_texture, clearcoat_roughness_texture, clearcoat_normal_texture;
  float transmission;
  TextureLookup transmission_texture;
};

/// BSDF parameters of a surface with this base colour (textures and vertex colours included), seen with the
/// footprint `at`. Leaves the coat's normal and the transmitted share to the caller.
BsdfParameters bsdf_parameters(const SurfaceMaterial& material, const Color& base_color,
                               const TextureFootprint& at);

struct Materials {
  std::deque<MipTexture> textures;
  std::vector<SurfaceMaterial> surfaces;  ///< numbered as the scene's
};

/// Builds the mip pyramids and resolves the scene's materials. White unlit materials get the radiance
/// `unlit_white`, kcd/m². Throws std::runtime_error in one line where an index, a size or a number in the
/// scene is wrong.
Materials make_materials(const Scene& scene, float unlit_white);

}  // namespace cps
