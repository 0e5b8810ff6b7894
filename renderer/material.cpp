#include "renderer/material.h"

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
  for (const TextureSlot* slot : {&material.base_color_texture, &material.metallic_roughness_texture,
                                  &material.normal_texture, &material.emissive_texture}) {
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

Materials make_materials(const Scene& scene) {
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
    request(material.base_color_texture, material.alpha_mode != AlphaMode::opaque);
    request(material.metallic_roughness_texture, false);
    request(material.normal_texture, false);
    request(material.emissive_texture, false);
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
    result.surfaces.push_back(std::move(surface));
  }
  return result;
}

}  // namespace cps
