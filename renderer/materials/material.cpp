#include "renderer/materials/material.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace cps {
namespace {

void check_texture(const Texture& texture) {
  const auto texels = static_cast<std::size_t>(std::max(texture.width, 0)) * std::max(texture.height, 0);
  if (texels == 0 || texture.rgba.size() != 4 * texels) {
    throw std::runtime_error("texture '" + texture.name + "': " + std::to_string(texture.rgba.size()) +
                             " bytes for " + std::to_string(texture.width) + "x" +
                             std::to_string(texture.height) + " RGBA texels: the image must be complete");
  }
}

void check_material(const Scene& scene, const Material& material) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error("material '" + material.name + "': " + what);
  };
  for (const TextureSlot* slot : texture_slots(material)) {
    if (slot->texture >= static_cast<int>(scene.textures.size()))
      fail("names a texture that the scene does not have");
    if (slot->texture >= 0 && (slot->uv_set < 0 || slot->uv_set > 1))
      fail("texture coordinates must be set 0 or 1");
    if (!slot->uv_transform.matrix().allFinite()) fail("its texture transform must be finite");
  }
  if (!(material.base_color.array() >= 0).all() || !material.base_color.allFinite())
    fail("base color must be >= 0");
  if (!(material.emissive.array() >= 0).all() || !material.emissive.allFinite())
    fail("emissive must be >= 0");
  if (!(material.metallic >= 0 && material.metallic <= 1)) fail("metallic must lie in [0, 1]");
  if (!(material.roughness >= 0 && material.roughness <= 1)) fail("roughness must lie in [0, 1]");
  if (!std::isfinite(material.normal_scale) || !std::isfinite(material.alpha_cutoff))
    fail("factors must be finite");
  if (!(material.ior == 0 || (material.ior >= 1 && std::isfinite(material.ior))))
    fail("ior must be 0 or at least 1");
  for (const float share :
       {material.specular, material.clearcoat, material.clearcoat_roughness, material.transmission}) {
    if (!(share >= 0 && share <= 1)) fail("specular, clearcoat and transmission must lie in [0, 1]");
  }
  if (!(material.specular_color.array() >= 0).all() || !material.specular_color.allFinite() ||
      !std::isfinite(material.clearcoat_normal_scale)) {
    fail("specular color and clearcoat normal scale must be finite, the color >= 0");
  }
}

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

}  // namespace

BsdfParameters bsdf_parameters(const SurfaceMaterial& material, const Color& base_color,
                               const TextureFootprint& at) {
  BsdfParameters p;
  // What reflects more than arrives would brighten with every bounce.
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
  for (const Texture& texture : scene.textures) check_texture(texture);
  for (const Material& material : scene.materials) check_material(scene, material);

  // One pyramid per texture and way of averaging; only those that some material reads.
  using Key = std::pair<int, bool>;
  std::map<Key, std::size_t> pyramid_of;
  std::vector<Key> keys;
  const auto request = [&](const TextureSlot& slot, bool weigh_by_alpha) {
    if (slot.texture < 0) return;
    const auto [entry, is_new] = pyramid_of.try_emplace({slot.texture, weigh_by_alpha}, keys.size());
    if (is_new) keys.push_back(entry->first);
  };
  for (const Material& material : scene.materials) {
    for (const TextureSlot* slot : texture_slots(material)) {
      const bool is_base_color = slot == &material.base_color_texture;
      request(*slot, is_base_color && material.alpha_mode != AlphaMode::opaque);
    }
  }
  Materials result;
  result.textures.resize(keys.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
    result.textures[i] = make_mip_texture(scene.textures[keys[i].first], keys[i].second);
  });
  const auto lookup = [&](const TextureSlot& slot, bool weigh_by_alpha) {
    return make_lookup(
        slot, slot.texture < 0 ? nullptr : &result.textures[pyramid_of.at({slot.texture, weigh_by_alpha})]);
  };

  result.surfaces.reserve(scene.materials.size());
  for (const Material& material : scene.materials) {
    SurfaceMaterial surface{};
    surface.base_color = material.base_color.array();
    surface.metallic = material.metallic;
    surface.roughness = material.roughness;
    surface.emissive = material.emissive.array();
    surface.base_color_texture =
        lookup(material.base_color_texture, material.alpha_mode != AlphaMode::opaque);
    surface.metallic_roughness_texture = lookup(material.metallic_roughness_texture, false);
    surface.normal_texture = lookup(material.normal_texture, false);
    surface.emissive_texture = lookup(material.emissive_texture, false);
    surface.normal_scale = material.normal_scale;
    surface.alpha_mode = material.alpha_mode;
    surface.alpha_cutoff = material.alpha_cutoff;
    if (material.alpha_mode == AlphaMode::mask && surface.base_color_texture.texture &&
        material.base_color.w() > 0) {
      surface.mask = make_alpha_mask(*surface.base_color_texture.texture,
                                     material.alpha_cutoff / material.base_color.w());
    }
    surface.double_sided = material.double_sided;
    surface.emits = (material.emissive.array() > 0).any();
    surface.transmits = material.transmission > 0 && material.metallic < 1 && !material.unlit;
    surface.unlit = material.unlit;
    surface.unlit_radiance = unlit_white;
    surface.dielectric_f0 = f0_of_ior(material.ior);
    surface.specular = material.specular;
    surface.specular_color = material.specular_color.array();
    surface.specular_texture = lookup(material.specular_texture, false);
    surface.specular_color_texture = lookup(material.specular_color_texture, false);
    surface.clearcoat = material.clearcoat;
    surface.clearcoat_roughness = material.clearcoat_roughness;
    surface.clearcoat_normal_scale = material.clearcoat_normal_scale;
    surface.clearcoat_texture = lookup(material.clearcoat_texture, false);
    surface.clearcoat_roughness_texture = lookup(material.clearcoat_roughness_texture, false);
    surface.clearcoat_normal_texture = lookup(material.clearcoat_normal_texture, false);
    surface.transmission = material.transmission;
    surface.transmission_texture = lookup(material.transmission_texture, false);
    result.surfaces.push_back(std::move(surface));
  }
  return result;
}

}  // namespace cps
