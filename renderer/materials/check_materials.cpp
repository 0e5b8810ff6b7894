#include "renderer/materials/check_materials.h"

#include <algorithm>
#include <cmath>
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

}  // namespace

void check_materials(const Scene& scene) {
  for (const Texture& texture : scene.textures) check_texture(texture);
  for (const Material& material : scene.materials) check_material(scene, material);
}

}  // namespace cps
