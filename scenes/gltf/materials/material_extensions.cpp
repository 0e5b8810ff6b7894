#include "scenes/gltf/materials/material_extensions.h"

#include "scenes/gltf/materials/factors.h"
#include "scenes/gltf/materials/specular_glossiness.h"
#include "scenes/gltf/materials/textures.h"

namespace cps::gltf {
namespace {

/// An extension of a material; `where` is its JSON path, for messages.
struct Extension {
  MaterialTable& table;
  const tinygltf::Value& value;
  std::string where;

  float number(const char* key, double missing, double max) const {
    const double found = extension_numbers(table.document, value, key, {missing}, where)[0];
    return factor(table.document, found, max, where + "." + key);
  }
  TextureSlot texture(const char* key, bool srgb = false) const {
    return extension_texture(table, value, key, srgb, where);
  }
};

void read_ior(const Extension& from, Material& to) {
  to.ior = from.number("ior", 1.5, 100);
  if (to.ior > 0 && to.ior < 1) {
    warn(from.table.document, from.where + ".ior is below 1, taken as 1");
    to.ior = 1;
  }
}

void read_specular(const Extension& from, Material& to) {
  to.specular = from.number("specularFactor", 1, 1);
  to.specular_texture = from.texture("specularTexture");
  const auto color =
      extension_numbers(from.table.document, from.value, "specularColorFactor", {1, 1, 1}, from.where);
  for (int c = 0; c < 3; ++c)
    to.specular_color[c] = factor(from.table.document, color[c], 1e6, from.where + ".specularColorFactor");
  to.specular_color_texture = from.texture("specularColorTexture", true);
}

void read_clearcoat(const Extension& from, Material& to) {
  to.clearcoat = from.number("clearcoatFactor", 0, 1);
  to.clearcoat_texture = from.texture("clearcoatTexture");
  to.clearcoat_roughness = from.number("clearcoatRoughnessFactor", 0, 1);
  to.clearcoat_roughness_texture = from.texture("clearcoatRoughnessTexture");
  to.clearcoat_normal_texture = from.texture("clearcoatNormalTexture");
  if (to.clearcoat_normal_texture.texture == -1) return;
  const tinygltf::Value& info = from.value.Get("clearcoatNormalTexture");
  to.clearcoat_normal_scale = static_cast<float>(
      extension_numbers(from.table.document, info, "scale", {1}, from.where + ".clearcoatNormalTexture")[0]);
}

void read_transmission(const Extension& from, Material& to) {
  to.transmission = from.number("transmissionFactor", 0, 1);
  to.transmission_texture = from.texture("transmissionTexture");
}

void read_emissive_strength(const Extension& from, Material& to) {
  to.emissive *= from.number("emissiveStrength", 1, 1e9);
}

/// Diffuse colour, colour of reflection at normal incidence, and gloss: a dielectric with that reflectance.
void read_specular_glossiness(const Extension& from, Material& to) {
  Document& document = from.table.document;
  const auto diffuse = extension_numbers(document, from.value, "diffuseFactor", {1, 1, 1, 1}, from.where),
             specular = extension_numbers(document, from.value, "specularFactor", {1, 1, 1}, from.where);
  constexpr float default_reflectance = 0.04f;  // of Material::ior 1.5, which specular_color multiplies
  for (int c = 0; c < 4; ++c)
    to.base_color[c] = factor(document, diffuse[c], 1, from.where + ".diffuseFactor");
  for (int c = 0; c < 3; ++c)
    to.specular_color[c] =
        factor(document, specular[c], 1, from.where + ".specularFactor") / default_reflectance;
  to.base_color_texture = from.texture("diffuseTexture", true);
  to.specular_color_texture = from.texture("specularGlossinessTexture", true);
  to.metallic = 0;
  const float glossiness = from.number("glossinessFactor", 1, 1);
  to.roughness = 1 - glossiness;
  to.metallic_roughness_texture = from.texture("specularGlossinessTexture");
  if (to.metallic_roughness_texture.texture == -1) return;
  to.roughness = 1;
  to.metallic_roughness_texture.texture =
      roughness_texture(from.table, to.metallic_roughness_texture.texture, glossiness);
}

void read_unlit(const Extension&, Material& to) {
  to.unlit = true;
}

}  // namespace

void read_material_extensions(MaterialTable& table, const tinygltf::ExtensionMap& extensions,
                              const std::string& where, Material& material) {
  using Reader = void (*)(const Extension&, Material&);
  constexpr std::pair<const char*, Reader> readers[] = {
      {"KHR_materials_pbrSpecularGlossiness", read_specular_glossiness},
      {"KHR_materials_ior", read_ior},
      {"KHR_materials_specular", read_specular},
      {"KHR_materials_clearcoat", read_clearcoat},
      {"KHR_materials_transmission", read_transmission},
      {"KHR_materials_emissive_strength", read_emissive_strength},
      {"KHR_materials_unlit", read_unlit}};
  for (const auto& [name, read] : readers)
    if (const auto found = extensions.find(name); found != extensions.end())
      read({table, found->second, where + "." + name}, material);
}

}  // namespace cps::gltf
