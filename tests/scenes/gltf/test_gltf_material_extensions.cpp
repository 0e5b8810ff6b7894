#include <catch2/catch.hpp>

#include "scenes/diffuse_materials.h"
#include "tests/scenes/gltf/gltf_maker.h"

using nlohmann::json;

namespace {

GltfMaker square_with(const json& extensions) {
  GltfMaker maker = one_square();
  maker.json["materials"][0]["extensions"] = extensions;
  for (const auto& [name, value] : extensions.items()) maker.json["extensionsUsed"].push_back(name);
  return maker;
}

}  // namespace

TEST_CASE("material extensions for glass, clear coat, specular, index of refraction and unlit") {
  std::vector<std::string> warnings;
  GltfMaker maker = square_with(
      {{"KHR_materials_ior", {{"ior", 1.33}}},
       {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 2}}}},
       {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.8}, {"clearcoatRoughnessFactor", 0.1}}},
       {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
       {"KHR_materials_unlit", json::object()}});
  const cps::Material material = import_glb(maker, &warnings).materials.at(0);
  CHECK(warnings.empty());
  CHECK(material.ior == 1.33f);
  CHECK(material.specular == 0.5f);
  CHECK(material.specular_color == Eigen::Vector3f(1, 0.5f, 2));
  CHECK(material.clearcoat == 0.8f);
  CHECK(material.clearcoat_roughness == 0.1f);
  CHECK(material.transmission == 0.9f);
  CHECK(material.unlit);
}

TEST_CASE("textures of material extensions, as colour or data, with their transforms") {
  GltfMaker maker = square_with(
      {{"KHR_materials_clearcoat",
        {{"clearcoatFactor", 1},
         {"clearcoatTexture", {{"index", 0}}},
         {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.3}}}}},
       {"KHR_materials_specular", {{"specularColorTexture", {{"index", 0}}}}},
       {"KHR_materials_transmission",
        {{"transmissionFactor", 1},
         {"transmissionTexture",
          {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}}}}}}}}}});
  maker.add_texture(encode_image("png", 1, 1, 3, {1, 2, 3}));
  const cps::Scene scene = import_glb(maker);
  const cps::Material& m = scene.materials.at(0);
  REQUIRE(scene.textures.size() == 2);
  CHECK(scene.textures[m.specular_color_texture.texture].srgb);
  CHECK_FALSE(scene.textures[m.clearcoat_texture.texture].srgb);
  CHECK(m.clearcoat_normal_texture.texture == m.clearcoat_texture.texture);
  CHECK(m.clearcoat_normal_scale == 0.3f);
  CHECK((m.transmission_texture.uv_transform * Eigen::Vector2f(0, 0)).x() == 0.5f);
  CHECK(scene.meshes.at(0).tangents.size() == 4);  // for the coat's normal map
}

TEST_CASE("unsupported material extensions are ignored with one warning each") {
  std::vector<std::string> warnings;
  GltfMaker maker =
      square_with({{"KHR_materials_sheen", json::object()}, {"KHR_materials_volume", json::object()}});
  maker.json["materials"].push_back(maker.json["materials"][0]);
  import_glb(maker, &warnings);
  CHECK(warnings == std::vector<std::string>{"KHR_materials_sheen is not supported and left out",
                                             "KHR_materials_volume is not supported and left out"});
}

TEST_CASE("invalid material extensions are refused by name") {
  const auto refused = [](const char* name, const json& value) {
    return refusal(square_with({{name, value}}));
  };
  CHECK(refused("KHR_materials_ior", {{"ior", "high"}}) ==
        "materials[0].KHR_materials_ior.ior: must be 1 finite number(s)");
  CHECK(refused("KHR_materials_clearcoat", {{"clearcoatTexture", {{"texCoord", 0}}}}) ==
        "materials[0].KHR_materials_clearcoat.clearcoatTexture: names no texture");
  CHECK(refused("KHR_materials_clearcoat", {{"clearcoatTexture", {{"index", 7}}}}) ==
        "materials[0].KHR_materials_clearcoat.clearcoatTexture: texture 7 does not exist");
  CHECK(refused("KHR_materials_specular", {{"specularTexture", 3}}) ==
        "materials[0].KHR_materials_specular.specularTexture: names no texture");
}

TEST_CASE("a diffuse material keeps only base colour, alpha and emission") {
  cps::Scene scene = import_glb(square_with({{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
                                             {"KHR_materials_transmission", {{"transmissionFactor", 1}}}}));
  scene.materials[0].base_color = {0.1f, 0.2f, 0.3f, 0.4f};
  scene.materials[0].alpha_mode = cps::AlphaMode::mask;
  cps::make_diffuse(scene);
  const cps::Material& m = scene.materials[0];
  CHECK(m.base_color == Eigen::Vector4f(0.1f, 0.2f, 0.3f, 0.4f));
  CHECK(m.alpha_mode == cps::AlphaMode::mask);
  CHECK(m.metallic == 0);
  CHECK(m.specular == 0);
  CHECK(m.clearcoat == 0);
  CHECK(m.transmission == 0);
}

TEST_CASE("specular and glossiness become a dielectric of that reflectance and roughness") {
  GltfMaker maker = square_with({{"KHR_materials_pbrSpecularGlossiness",
                                  {{"diffuseFactor", {0.8, 0.4, 0.2, 0.5}},
                                   {"specularFactor", {0.1, 0.2, 1}},
                                   {"glossinessFactor", 0.75}}}});
  std::vector<std::string> warnings;
  const cps::Material plain = import_glb(maker, &warnings).materials.at(0);
  CHECK(warnings.empty());
  CHECK(plain.base_color == Eigen::Vector4f(0.8f, 0.4f, 0.2f, 0.5f));
  CHECK(plain.metallic == 0);
  CHECK(plain.roughness == 0.25f);
  CHECK(plain.ior == 1.5f);  // reflects 4 %, times specular_color
  CHECK((0.04f * plain.specular_color).isApprox(Eigen::Vector3f(0.1f, 0.2f, 1)));

  maker.add_texture(encode_image("png", 1, 1, 4, {255, 128, 0, 100}));
  maker.json["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"]
            ["specularGlossinessTexture"] = {{"index", 0}};
  const cps::Scene scene = import_glb(maker);
  const cps::Material& m = scene.materials.at(0);
  CHECK(m.roughness == 1);
  CHECK(scene.textures[m.specular_color_texture.texture].srgb);
  const cps::Texture& roughness = scene.textures[m.metallic_roughness_texture.texture];
  CHECK_FALSE(roughness.srgb);
  CHECK(int{roughness.rgba[1]} == 255 - 75);  // 1 - .75 * 100 / 255, of 255
  CHECK(roughness.rgba[2] == 0);
}
