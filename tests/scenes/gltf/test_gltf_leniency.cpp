#include <catch2/catch.hpp>
#include <fstream>

#include "scenes/gltf_import.h"
#include "tests/scenes/gltf/gltf_maker.h"

using Eigen::Vector3f;
using nlohmann::json;

namespace {

std::vector<std::string> warnings_of(const GltfMaker& maker) {
  std::vector<std::string> warnings;
  import_glb(maker, &warnings);
  return warnings;
}

/// A second node with a copy of the mesh that `change` has changed.
template <class Change>
GltfMaker with_second_mesh(GltfMaker maker, Change change) {
  maker.json["meshes"].push_back(maker.json["meshes"][0]);
  maker.json["nodes"].push_back({{"mesh", 1}});
  maker.json["scenes"][0]["nodes"].push_back(maker.json["nodes"].size() - 1);
  change(maker, maker.json["meshes"][1]["primitives"][0]);
  return maker;
}

}  // namespace

TEST_CASE("a buffer's file may be longer than the buffer") {
  const GltfMaker maker = one_triangle();
  const TemporaryFolder folder;
  const std::string text = maker.gltf("b.bin");
  std::vector<unsigned char> longer = maker.buffer;
  longer.resize(longer.size() + 100);
  write_file(folder.path / "t.gltf", text.data(), text.size());
  write_file(folder.path / "b.bin", longer.data(), longer.size());
  CHECK(cps::import_gltf(folder.path / "t.gltf").meshes.size() == 1);
}

TEST_CASE("URIs are decoded by percent signs alone; names that are not encoded are found, too") {
  const GltfMaker maker = one_triangle();
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "sub");
  const std::pair<const char*, const char*> files[] = {{"a+b.bin", "a+b.bin"},   {"a%20b.bin", "a b.bin"},
                                                       {"a b.bin", "a b.bin"},   {"50%off.bin", "50%off.bin"},
                                                       {"x%2By.bin", "x+y.bin"}, {"%C3%A4.bin", "ä.bin"},
                                                       {"ö.bin", "ö.bin"},       {"sub\\c.bin", "sub/c.bin"}};
  for (const auto& [uri, file] : files) {
    INFO(uri);
    const std::string text = maker.gltf(uri);
    write_file(folder.path / "t.gltf", text.data(), text.size());
    write_file(folder.path / file, maker.buffer.data(), maker.buffer.size());
    CHECK(cps::import_gltf(folder.path / "t.gltf").meshes.size() == 1);
    std::filesystem::remove(folder.path / file);
    CHECK_THROWS_WITH(cps::import_gltf(folder.path / "t.gltf"),
                      Catch::Contains("is not beside the glTF file"));
  }
}

TEST_CASE("empty meshes and buffers are left out with a warning") {
  const GltfMaker no_positions = with_second_mesh(one_triangle(), [](GltfMaker& maker, json& primitive) {
    maker.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 0}});
    primitive["attributes"]["POSITION"] = maker.json["accessors"].size() - 1;
  });
  CHECK(import_glb(no_positions).instances.size() == 1);
  CHECK(warnings_of(no_positions) ==
        std::vector<std::string>{"meshes[1].primitives[0]: is empty and not drawn"});
  GltfMaker empty_buffer = one_triangle();
  empty_buffer.json["buffers"] = {{{"byteLength", empty_buffer.buffer.size()}},
                                  {{"byteLength", 0}, {"uri", "data:,"}}};
  CHECK(import_glb(empty_buffer).instances.size() == 1);
  CHECK(warnings_of(empty_buffer) == std::vector<std::string>{"buffers[1] is empty and left out"});
}

TEST_CASE("animations of any kind are left out with a warning") {
  GltfMaker maker = one_triangle();
  // KHR_animation_pointer: a channel whose target is no node.
  maker.json["animations"] = {
      {{"samplers", {{{"input", 0}, {"output", 0}}}},
       {"channels",
        {{{"sampler", 0},
          {"target",
           {{"path", "pointer"},
            {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/0/scale"}}}}}}}}}}}};
  CHECK(warnings_of(maker) == std::vector<std::string>{"animations are not played, the rest pose is drawn"});
}

TEST_CASE("a skin without inverse bind matrices has identities") {
  GltfMaker with = skinned_triangle(), without = with;
  without.json["skins"][0].erase("inverseBindMatrices");
  const int identities = with.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                                          1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                                         "MAT4");
  with.json["skins"][0]["inverseBindMatrices"] = identities;
  CHECK(import_glb(without).meshes.at(0).positions == import_glb(with).meshes.at(0).positions);
}

TEST_CASE("triangles whose vertices have no weight are left out with a warning") {
  GltfMaker maker = skinned_triangle();
  // A second triangle, on vertices of its own; one of them has no weight.
  json& attributes = maker.primitive()["attributes"];
  attributes["POSITION"] = maker.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0}, "VEC3");
  attributes["JOINTS_0"] = maker.add(std::vector<std::uint8_t>(24, 0), 5121, "VEC4", 6);
  std::vector<float> weights(24, 0);
  for (int vertex : {0, 1, 2, 3, 5}) weights[4 * vertex] = 1;
  attributes["WEIGHTS_0"] = maker.add_floats(weights, "VEC4");
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.triangles.size() == 1);
  CHECK(mesh.positions[0].isApprox(Vector3f(6, 0, 0)));
  CHECK(warnings_of(maker) ==
        std::vector<std::string>{
            "meshes[0].primitives[0].WEIGHTS_0: 1 vertices have no weight, their triangles are not drawn"});
}

TEST_CASE("invisible nodes and what is below them are not drawn") {
  GltfMaker maker = one_triangle();
  const json hidden = {{"KHR_node_visibility", {{"visible", false}}}};
  maker.json["extensionsUsed"] = {"KHR_node_visibility"};
  maker.json["nodes"] = {{{"mesh", 0}},
                         {{"mesh", 0}, {"extensions", hidden}, {"children", {2}}},
                         {{"mesh", 0}},
                         {{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}}};
  maker.json["scenes"][0]["nodes"] = {0, 1, 3};
  CHECK(import_glb(maker).instances.size() == 2);
  CHECK(warnings_of(maker).empty());
}

TEST_CASE("a third set of texture coordinates is read where a texture uses it") {
  GltfMaker maker = one_square();
  const int texture = maker.add_texture(encode_image("png", 1, 1, 3, {1, 2, 3}));
  maker.primitive()["attributes"]["TEXCOORD_2"] =
      maker.add_floats({.1f, .2f, .3f, .4f, .5f, .6f, .7f, .8f}, "VEC2");
  maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture},
                                                                            {"texCoord", 2}};
  maker.json["materials"][0]["emissiveTexture"] = {{"index", texture}, {"texCoord", 0}};
  const cps::Scene scene = import_glb(maker);
  const cps::Material& material = scene.materials[0];
  const cps::Mesh& mesh = scene.meshes[0];
  const auto coordinate = [&](const cps::TextureSlot& slot) {
    return (slot.uv_set == 0 ? mesh.uv0 : mesh.uv1)[1];
  };
  CHECK(coordinate(material.base_color_texture) == Eigen::Vector2f(.3f, .4f));
  CHECK(coordinate(material.emissive_texture) == Eigen::Vector2f(1, 1));
}

TEST_CASE("a node with a scale of 0 along one axis is drawn flat, along two axes not at all") {
  GltfMaker maker = one_square();
  maker.json["nodes"] = {{{"mesh", 0}, {"scale", {2, 3, 0}}, {"translation", {0, 0, 7}}},
                         {{"mesh", 0}, {"scale", {0, 3, 0}}}};
  maker.json["scenes"][0]["nodes"] = {0, 1};
  const cps::Scene scene = import_glb(maker);
  REQUIRE(scene.instances.size() == 1);
  const cps::Mesh& flat = scene.meshes[scene.instances[0].mesh];
  CHECK(scene.instances[0].world_from_mesh.matrix() == Eigen::Matrix4f::Identity());
  CHECK(flat.positions[2] == Vector3f(2, 3, 7));
  CHECK(flat.normals[2].isApprox(Vector3f(0, 0, 1)));
  CHECK(flat.triangles.size() == 2);
  CHECK(warnings_of(maker) == std::vector<std::string>{"nodes[1]: its scale is 0 along two axes, not drawn"});
}

TEST_CASE("a scene far from its origin keeps its millimetres") {
  GltfMaker maker = one_triangle();
  json& positions = maker.json["accessors"][0];
  positions["min"] = {0, 0, 0};
  positions["max"] = {1, 1, 0};
  maker.json["nodes"] = {{{"translation", {456068.251, 112.15, -5430320.05}}, {"children", {1, 2}}},
                         {{"mesh", 0}},
                         {{"mesh", 0}, {"translation", {0.003, 0, 0}}}};
  maker.json["scenes"][0]["nodes"] = {0};
  maker.json["scenes"][0]["extras"]["cps_lanes"] = {
      {{"street", "A"}, {"points", {{456068.251, 112.15, -5430320.05}, {456069.251, 112.15, -5430320.05}}}}};
  const cps::Scene scene = import_glb(maker);
  CHECK(scene.origin.norm() > 5e6);
  CHECK(scene.origin == Eigen::Vector3d(scene.origin.array().round()));  // whole metres are exact in text
  const auto in_file = [&](const Vector3f& point) {
    return Eigen::Vector3d(scene.origin + point.cast<double>());
  };
  const Vector3f first = scene.instances.at(0).world_from_mesh.translation();
  CHECK((in_file(first) - Eigen::Vector3d(456068.251, 112.15, -5430320.05)).norm() < 1e-6);
  CHECK(scene.instances.at(1).world_from_mesh.translation().x() - first.x() == Approx(0.003).epsilon(0.001));
  CHECK((scene.lanes.at(0).points[0] - first).norm() < 1e-6f);
  // Near its origin, a scene stays where it is.
  maker.json["nodes"][0]["translation"] = {5000, 0, 0};
  CHECK(import_glb(maker).origin.isZero());
}
