#include "scenes/gltf/materials/materials.h"

#include <algorithm>
#include <cmath>

#include "scenes/gltf/materials/factors.h"
#include "scenes/gltf/materials/material_extensions.h"
#include "scenes/gltf/materials/textures.h"
#include "scenes/gltf/materials/uv_sets.h"

namespace cps::gltf {
namespace {

AlphaMode alpha_mode(const Document& document, const std::string& mode, const std::string& where) {
  if (mode == "OPAQUE") return AlphaMode::opaque;
  if (mode == "MASK") return AlphaMode::mask;
  if (mode == "BLEND") return AlphaMode::blend;
  refuse(document, where, "\"" + mode + "\" is not OPAQUE, MASK or BLEND");
}

Material make_material(MaterialTable& table, int index) {
  Document& document = table.document;
  const std::string where = element("materials", index);
  const tinygltf::Material& from = document.model.materials[index];
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  Material to;
  to.name = from.name;
  for (int c = 0; c < 4; ++c)
    to.base_color[c] = factor(document, pbr.baseColorFactor[c], 1, where + ".baseColorFactor");
  to.metallic = factor(document, pbr.metallicFactor, 1, where + ".metallicFactor");
  to.roughness = factor(document, pbr.roughnessFactor, 1, where + ".roughnessFactor");
  for (int c = 0; c < 3; ++c)
    to.emissive[c] = factor(document, from.emissiveFactor[c], 1e9, where + ".emissiveFactor");

  const auto slot = [&](const auto& info, bool srgb, const char* name) {
    return texture_slot(table, info.index, info.texCoord, info.extensions, srgb, where + "." + name);
  };
  to.base_color_texture = slot(pbr.baseColorTexture, true, "baseColorTexture");
  to.metallic_roughness_texture = slot(pbr.metallicRoughnessTexture, false, "metallicRoughnessTexture");
  to.normal_texture = slot(from.normalTexture, false, "normalTexture");
  to.emissive_texture = slot(from.emissiveTexture, true, "emissiveTexture");
  if (!std::isfinite(from.normalTexture.scale))
    refuse(document, where + ".normalTexture.scale", "is not finite");
  to.normal_scale = static_cast<float>(from.normalTexture.scale);

  to.alpha_mode = alpha_mode(document, from.alphaMode, where + ".alphaMode");
  to.alpha_cutoff = factor(document, from.alphaCutoff, 1e9, where + ".alphaCutoff");
  to.double_sided = from.doubleSided;
  read_material_extensions(table, from.extensions, where, to);
  return to;
}

}  // namespace

int material_index(MaterialTable& table, int gltf_material, const std::string& where) {
  if (gltf_material != -1 && !in_range(gltf_material, table.document.model.materials))
    refuse(table.document, where + ".material", std::to_string(gltf_material) + " does not exist");
  const auto [found, is_new] = table.materials.try_emplace(gltf_material, -1);
  if (is_new) {
    Material material;
    if (gltf_material != -1) material = make_material(table, gltf_material);
    table.uv_sets.push_back(choose_uv_sets(table.document, material, element("materials", gltf_material)));
    table.scene.materials.push_back(std::move(material));
    found->second = static_cast<int>(table.scene.materials.size()) - 1;
  }
  return found->second;
}

}  // namespace cps::gltf
