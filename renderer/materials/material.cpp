#include "renderer/materials/material.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "renderer/materials/check_materials.h"

namespace cps {
namespace {

/// Reflectance at normal incidence against air (KHR_materials_ior).
float f0_of_ior(float ior) {
  if (ior == 0.0f) return 1.0f;
  const float root = (ior - 1.0f) / (ior + 1.0f);
  return root * root;
}

TextureLookup make_lookup(const TextureSlot& slot, const MipTexture* texture) {
  TextureLookup lookup;
  lookup.texture = texture;
  lookup.uv_set = slot.uv_set;
  lookup.transform = slot.uv_transform.matrix().topRows<2>();
  if (texture) {
    const MipTexture::Level& image = texture->levels[0];
    const float texels = static_cast<float>(image.width) * static_cast<float>(image.height);
    const float scale = std::abs(lookup.transform.leftCols<2>().determinant());
    lookup.log2_texels_per_uv = 0.5f * std::log2(std::max(texels * scale, 1e-20f));
  }
  return lookup;
}

/// The mip pyramids of a scene's textures: one per texture and way of averaging that some material reads.
class Pyramids {
 public:
  /// Builds them in `textures`, which lookups point into.
  Pyramids(const Scene& scene, std::deque<MipTexture>& textures) : textures_(textures) {
    std::vector<Key> keys;
    for (const Material& material : scene.materials) {
      for (const TextureSlot* slot : texture_slots(material)) {
        if (slot->texture < 0) continue;
        const Key key{slot->texture, slot == &material.base_color_texture && cuts_holes(material)};
        if (index_of_.try_emplace(key, keys.size()).second) keys.push_back(key);
      }
    }
    textures.resize(keys.size());
    tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
      textures[i] = make_mip_texture(scene.textures[keys[i].first], keys[i].second);
    });
  }

  TextureLookup lookup(const TextureSlot& slot, bool weigh_by_alpha = false) const {
    return make_lookup(slot,
                       slot.texture < 0 ? nullptr : &textures_[index_of_.at({slot.texture, weigh_by_alpha})]);
  }

  /// Whether the base colour's alpha matters, so that transparent texels must not tint averages.
  static bool cuts_holes(const Material& material) { return material.alpha_mode != AlphaMode::opaque; }

 private:
  using Key = std::pair<int, bool>;  ///< texture, and whether its alpha weighs
  std::map<Key, std::size_t> index_of_;
  std::deque<MipTexture>& textures_;
};

SurfaceMaterial resolved(const Material& material, const Pyramids& pyramids, float unlit_white) {
  SurfaceMaterial surface{};
  surface.base_color = material.base_color.array();
  surface.metallic = material.metallic;
  surface.roughness = material.roughness;
  surface.emissive = material.emissive.array();
  surface.base_color_texture = pyramids.lookup(material.base_color_texture, Pyramids::cuts_holes(material));
  surface.metallic_roughness_texture = pyramids.lookup(material.metallic_roughness_texture);
  surface.normal_texture = pyramids.lookup(material.normal_texture);
  surface.emissive_texture = pyramids.lookup(material.emissive_texture);
  surface.normal_scale = material.normal_scale;
  surface.alpha_mode = material.alpha_mode;
  surface.alpha_cutoff = material.alpha_cutoff;
  if (material.alpha_mode == AlphaMode::mask && surface.base_color_texture.texture &&
      material.base_color.w() > 0) {
    surface.mask =
        make_alpha_mask(*surface.base_color_texture.texture, material.alpha_cutoff / material.base_color.w());
  }
  surface.double_sided = material.double_sided;
  surface.emits = (material.emissive.array() > 0).any();
  surface.transmits = material.transmission > 0 && material.metallic < 1 && !material.unlit;
  surface.unlit = material.unlit;
  surface.unlit_radiance = unlit_white;
  surface.dielectric_f0 = f0_of_ior(material.ior);
  surface.specular = material.specular;
  surface.specular_color = material.specular_color.array();
  surface.specular_texture = pyramids.lookup(material.specular_texture);
  surface.specular_color_texture = pyramids.lookup(material.specular_color_texture);
  surface.clearcoat = material.clearcoat;
  surface.clearcoat_roughness = material.clearcoat_roughness;
  surface.clearcoat_normal_scale = material.clearcoat_normal_scale;
  surface.clearcoat_texture = pyramids.lookup(material.clearcoat_texture);
  surface.clearcoat_roughness_texture = pyramids.lookup(material.clearcoat_roughness_texture);
  surface.clearcoat_normal_texture = pyramids.lookup(material.clearcoat_normal_texture);
  surface.transmission = material.transmission;
  surface.transmission_texture = pyramids.lookup(material.transmission_texture);
  return surface;
}

}  // namespace

BsdfParameters bsdf_parameters(const SurfaceMaterial& material, const Color& base_color,
                               const TextureFootprint& at) {
  BsdfParameters p;
  // A surface that reflected more light than arrives would brighten with every bounce.
  p.base_color = base_color.min(1.0f);
  p.metallic = material.metallic;
  p.roughness = material.roughness;
  if (material.metallic_roughness_texture.texture) {
    const Eigen::Array4f texel = material.metallic_roughness_texture.sample(at);
    p.roughness *= texel.y();
    p.metallic *= texel.z();
  }
  Color specular_color = material.specular_color;
  p.dielectric_f90 = material.specular;
  if (material.specular_color_texture.texture)
    specular_color *= material.specular_color_texture.sample(at).head<3>();
  if (material.specular_texture.texture) p.dielectric_f90 *= material.specular_texture.sample(at).w();
  p.dielectric_f0 = (material.dielectric_f0 * specular_color).min(1.0f) * p.dielectric_f90;
  if (material.clearcoat > 0.0f) {
    p.clearcoat = material.clearcoat;
    p.clearcoat_roughness = material.clearcoat_roughness;
    if (material.clearcoat_texture.texture) p.clearcoat *= material.clearcoat_texture.sample(at).x();
    if (material.clearcoat_roughness_texture.texture)
      p.clearcoat_roughness *= material.clearcoat_roughness_texture.sample(at).y();
  }
  if (material.transmits) {
    p.transmission = material.transmission;
    if (material.transmission_texture.texture) p.transmission *= material.transmission_texture.sample(at).x();
  }
  return p;
}

Materials make_materials(const Scene& scene, float unlit_white) {
  check_materials(scene);
  Materials result;
  const Pyramids pyramids(scene, result.textures);
  result.surfaces.reserve(scene.materials.size());
  for (const Material& material : scene.materials)
    result.surfaces.push_back(resolved(material, pyramids, unlit_white));
  return result;
}

}  // namespace cps
