#include <meshoptimizer.h>

#include <catch2/catch.hpp>

#include "tests/scenes/gltf/gltf_maker.h"

using Eigen::Vector3f;
using nlohmann::json;

namespace {

/// Compresses the buffer view of the accessor as EXT_meshopt_compression.
void compress(GltfMaker& maker, int accessor, const char* mode, std::size_t count, std::size_t stride,
              const char* filter = nullptr) {
  json& view = maker.json["bufferViews"][maker.json["accessors"][accessor]["bufferView"].get<int>()];
  const unsigned char* from = maker.buffer.data() + view["byteOffset"].get<std::size_t>();
  std::vector<unsigned char> bytes;
  if (mode == std::string("ATTRIBUTES")) {
    bytes.resize(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), from, count, stride));
  } else {
    const std::vector<std::uint16_t> indices(reinterpret_cast<const std::uint16_t*>(from),
                                             reinterpret_cast<const std::uint16_t*>(from) + count);
    bytes.resize(meshopt_encodeIndexBufferBound(count, 100));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), count));
  }
  const int compressed = maker.add_view(bytes.data(), bytes.size());
  json& same_view = maker.json["bufferViews"][maker.json["accessors"][accessor]["bufferView"].get<int>()];
  same_view["buffer"] = 1;
  json extension = {{"buffer", 0},
                    {"byteOffset", maker.json["bufferViews"][compressed]["byteOffset"]},
                    {"byteLength", bytes.size()},
                    {"byteStride", stride},
                    {"count", count},
                    {"mode", mode}};
  if (filter) extension["filter"] = filter;
  same_view["extensions"]["EXT_meshopt_compression"] = extension;
}

/// The square, its views compressed, with a fallback buffer that has no data.
GltfMaker compressed_square() {
  GltfMaker maker = one_square();
  const json attributes = maker.primitive()["attributes"];
  compress(maker, attributes["POSITION"], "ATTRIBUTES", 4, 12);
  compress(maker, attributes["TEXCOORD_0"], "ATTRIBUTES", 4, 8);
  compress(maker, maker.primitive()["indices"], "TRIANGLES", 6, 2);
  maker.json["buffers"] = {
      {{"byteLength", maker.buffer.size()}},
      {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  maker.json["extensionsUsed"] = maker.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  return maker;
}

}  // namespace

TEST_CASE("meshopt-compressed vertices and indices are those that were compressed") {
  const cps::Mesh expected = import_glb(one_square()).meshes.at(0);
  std::vector<std::string> warnings;
  const cps::Mesh mesh = import_glb(compressed_square(), &warnings).meshes.at(0);
  CHECK(warnings.empty());
  CHECK(mesh.positions == expected.positions);
  CHECK(mesh.uv0 == expected.uv0);
  // The index codec may turn a triangle's corners round.
  REQUIRE(mesh.triangles.size() == 2);
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Vector3f a = mesh.positions[triangle[0]];
    CHECK((mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a) == Vector3f(0, 0, 1));
  }
}

TEST_CASE("meshopt's exponential filter is undone") {
  GltfMaker maker = one_square();
  const json attributes = maker.primitive()["attributes"];
  // Mantissa 1 (24 bits), exponent −1 (8 bits): .5; exponent 2 and mantissa 3: 12.
  const std::uint32_t half = 0xff000001u, twelve = 0x02000003u;
  const std::vector<std::uint32_t> encoded{0, 0, 0, half, 0, 0, half, twelve, 0, 0, twelve, 0};
  const int accessor = maker.add(encoded, 5126, "VEC3", 4);
  maker.primitive()["attributes"]["POSITION"] = accessor;
  compress(maker, accessor, "ATTRIBUTES", 4, 12, "EXPONENTIAL");
  maker.json["buffers"] = {
      {{"byteLength", maker.buffer.size()}},
      {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  CHECK(import_glb(maker).meshes.at(0).positions[2] == Vector3f(0.5f, 12, 0));
}

TEST_CASE("broken meshopt data is refused by name") {
  GltfMaker maker = compressed_square();
  json& extension = maker.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  SECTION("cut off") {
    extension["byteLength"] = extension["byteLength"].get<int>() / 2;
    CHECK_THAT(refusal(maker), Catch::Contains("its data is broken"));
  }
  SECTION("beyond the buffer") {
    extension["byteOffset"] = 100000;
    CHECK_THAT(refusal(maker), Catch::Contains("reaches beyond its buffer"));
  }
  SECTION("a stride that the codec does not have") {
    extension["byteStride"] = 13;
    CHECK_THAT(refusal(maker), Catch::Contains("do not go together"));
  }
  SECTION("more than memory") {
    extension["count"] = 2000000000;
    CHECK_THAT(refusal(maker), Catch::Contains("MiB of vertices"));
  }
  SECTION("no such filter") {
    extension["filter"] = "COLOR";
    CHECK_THAT(refusal(maker), Catch::Contains("is not one of the extension's"));
  }
}
