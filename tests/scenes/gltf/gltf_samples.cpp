#include "tests/scenes/gltf/gltf_samples.h"

#include "tests/scenes/gltf/draco_grid.h"

namespace {

using Values = std::vector<std::uint8_t>;

/// Uses textures, a sparse accessor, samplers, transforms, mirrored and plain nodes, lanes.
GltfMaker textured() {
  GltfMaker maker = one_square();
  const int color = maker.add_texture(encode_image("png", 4, 4, 3, Values(48, 90)));
  const int normal = maker.add_texture(encode_image("jpeg", 8, 8, 3, Values(192, 128)));
  const std::uint16_t sparse_indices[] = {1};
  const float sparse_values[] = {2, 0, 0};
  const int index_view = maker.add_view(sparse_indices, sizeof sparse_indices);
  const int value_view = maker.add_view(sparse_values, sizeof sparse_values);
  maker.json["accessors"][0]["sparse"] = {{"count", 1},
                                          {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
                                          {"values", {{"bufferView", value_view}}}};
  maker.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  maker.json["textures"][0]["sampler"] = 0;
  maker.json["materials"][0] = {
      {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", color}}}, {"roughnessFactor", 0.5}}},
      {"normalTexture",
       {{"index", normal},
        {"extensions", {{"KHR_texture_transform", {{"offset", {0, 1}}, {"rotation", 1.5}}}}}}},
      {"alphaMode", "MASK"}};
  maker.json["nodes"] = {{{"children", {1, 2}}, {"rotation", {0, 0, 0, 1}}},
                         {{"mesh", 0}, {"scale", {-1, 1, 1}}},
                         {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1}}}};
  maker.json["scenes"][0]["extras"]["cps_lanes"] = {
      {{"street", "A"}, {"width_m", 3.5}, {"points", {{0, 0, 0}, {10, 0.5, -2}}}}};
  return maker;
}

/// Uses quantised vertices, colours, a WebP image, emission and blending.
GltfMaker quantized() {
  GltfMaker maker = one_square();
  nlohmann::json& attributes = maker.primitive()["attributes"];
  const Values normals = {0, 0, 127, 0, 0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 0};
  attributes["NORMAL"] =
      maker.add_accessor(maker.add_view(normals.data(), normals.size(), 4), 5120, "VEC3", 4, true);
  attributes["COLOR_0"] = maker.add(Values(16, 100), 5121, "VEC4", 4, true);
  attributes["TEXCOORD_1"] = maker.add(std::vector<std::uint16_t>(8, 30000), 5123, "VEC2", 4, true);
  maker.add_texture(encode_image("webp", 8, 8, 4, Values(256, 77)));
  maker.json["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  maker.json["materials"][0] = {
      {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
      {"emissiveFactor", {1, 1, 0}},
      {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}},
      {"alphaMode", "BLEND"},
      {"doubleSided", true}};
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization", "EXT_texture_webp"};
  return maker;
}

GltfMaker instanced() {
  GltfMaker maker = one_triangle();
  const int translations = maker.add_floats({1, 0, 0, 2, 0, 0}, "VEC3");
  maker.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", translations},
      {"ROTATION", maker.add_floats({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4")},
      {"SCALE", translations}};
  return maker;
}

GltfMaker strip() {
  GltfMaker maker = one_square();
  maker.primitive()["mode"] = 5;
  maker.primitive()["attributes"].erase("NORMAL");
  return maker;
}

}  // namespace

std::vector<std::vector<unsigned char>> gltf_samples() {
  const std::string text = strip().gltf();
  return {textured().glb(),           skinned_triangle().glb(), instanced().glb(),
          {text.begin(), text.end()}, quantized().glb(),        draco_grid().glb()};
}
