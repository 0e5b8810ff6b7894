#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/scenes/gltf/gltf_maker.h"

using Eigen::Vector3f;
using nlohmann::json;

TEST_CASE("interleaved attributes with a stride") {
  // Position, then normal, in 24-byte steps.
  const std::vector<float> values = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0};
  GltfMaker maker;
  const int view = maker.add_view(values.data(), values.size() * 4, 24);
  const int positions = maker.add_accessor(view, 5126, "VEC3", 3);
  const int normals = maker.add_accessor(view, 5126, "VEC3", 3);
  maker.json["accessors"][normals]["byteOffset"] = 12;
  maker.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}}}}}};
  maker.json["nodes"] = {{{"mesh", 0}}};
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.positions == std::vector<Vector3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh.normals == std::vector<Vector3f>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
}

TEST_CASE("indices of 8, 16 and 32 bits, or none, give the same triangles") {
  GltfMaker maker = one_square();
  const cps::Mesh expected = import_glb(maker).meshes.at(0);
  SECTION("8") {
    maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 6);
  }
  SECTION("32") {
    maker.primitive()["indices"] = maker.add(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, 5125, "SCALAR", 6);
  }
  CHECK(import_glb(maker).meshes.at(0).triangles == expected.triangles);
  CHECK(expected.triangles == std::vector<Eigen::Vector3i>{{0, 1, 2}, {0, 2, 3}});
  CHECK(import_glb(one_triangle()).meshes.at(0).triangles == std::vector<Eigen::Vector3i>{{0, 1, 2}});
}

TEST_CASE("quantised attributes: normalised ones are scaled as specified, others keep their values") {
  GltfMaker maker = one_square();
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  json& attributes = maker.primitive()["attributes"];
  // Four bytes per vertex, as vertex data is 4-byte aligned.
  const std::vector<std::int8_t> normals = {0, 0, 127, 0, 0, 0, -128, 0, 0, 127, 0, 0, -127, 0, 0, 0};
  const int normal_view = maker.add_view(normals.data(), normals.size(), 4);
  attributes["NORMAL"] = maker.add_accessor(normal_view, 5120, "VEC3", 4, true);
  attributes["TEXCOORD_0"] = maker.add(std::vector<std::uint16_t>{0, 65535, 65535, 65535, 65535, 0, 0, 13107},
                                       5123, "VEC2", 4, true);
  const std::vector<std::int16_t> positions = {0, 0, 0, 0, 100, 0, 0, 0, 100, -300, 0, 0, 0, 100, 7, 0};
  const int position_view = maker.add_view(positions.data(), positions.size() * 2, 8);
  attributes["POSITION"] = maker.add_accessor(position_view, 5122, "VEC3", 4);
  attributes["COLOR_0"] = maker.add(
      std::vector<std::uint8_t>{255, 0, 51, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 5121, "VEC4", 4, true);

  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.normals == std::vector<Vector3f>{{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}});
  CHECK(mesh.uv0[3] == Eigen::Vector2f(0, 0.2f));
  CHECK(mesh.positions[2] == Vector3f(100, -300, 0));
  CHECK(mesh.positions[3] == Vector3f(0, 100, 7));
  CHECK(mesh.colors[0] == Eigen::Vector4f(1, 0, 0.2f, 1));
}

TEST_CASE("colours of 8, 16 and 32 bits, with and without alpha, and normalised 16-bit positions") {
  GltfMaker maker = one_triangle();
  json& attributes = maker.primitive()["attributes"];
  const std::vector<std::uint8_t> rgb8 = {255, 51, 0, 0, 255, 51, 0, 0, 255, 51, 0, 0};
  const std::vector<std::uint16_t> rgba16 = {65535, 13107, 0,     65535, 65535, 13107,
                                             0,     65535, 65535, 13107, 0,     65535};
  SECTION("RGB, 8 bit") {
    attributes["COLOR_0"] = maker.add_accessor(maker.add_view(rgb8.data(), 12, 4), 5121, "VEC3", 3, true);
  }
  SECTION("RGBA, 16 bit") {
    attributes["COLOR_0"] = maker.add(rgba16, 5123, "VEC4", 3, true);
  }
  SECTION("RGB, 16 bit") {
    attributes["COLOR_0"] = maker.add_accessor(maker.add_view(rgba16.data(), 24, 8), 5123, "VEC3", 3, true);
  }
  SECTION("RGBA, float") {
    attributes["COLOR_0"] = maker.add_floats({1, 0.2f, 0, 1, 1, 0.2f, 0, 1, 1, 0.2f, 0, 1}, "VEC4");
  }
  const std::vector<std::int16_t> positions = {0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, -16384, 0};
  attributes["POSITION"] = maker.add_accessor(maker.add_view(positions.data(), 24, 8), 5122, "VEC3", 3, true);
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.colors == std::vector<Eigen::Vector4f>(3, {1, 0.2f, 0, 1}));
  CHECK(mesh.positions[1] == Vector3f(1, 0, 0));
  CHECK(mesh.positions[2] == Vector3f(0, -1, -16384.0f / 32767));
}

TEST_CASE("sparse accessors replace some elements of a buffer view or of zeros") {
  GltfMaker maker = one_triangle();
  const std::uint16_t indices[] = {1, 2};
  const float values[] = {5, 0, 0, 0, 6, 0};
  const int index_view = maker.add_view(indices, sizeof indices),
            value_view = maker.add_view(values, sizeof values);
  json& accessor = maker.json["accessors"][0];
  accessor["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
                        {"values", {{"bufferView", value_view}}}};
  SECTION("of a buffer view") {
    CHECK(import_glb(maker).meshes.at(0).positions == std::vector<Vector3f>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}});
  }
  SECTION("of zeros") {
    accessor.erase("bufferView");
    CHECK(import_glb(maker).meshes.at(0).positions == std::vector<Vector3f>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}});
  }
  const std::string where = "meshes[0].primitives[0].POSITION (accessors[0]): ";
  SECTION("indices that do not increase") {
    accessor["sparse"]["indices"]["byteOffset"] = 2;
    accessor["sparse"]["count"] = 1;
    CHECK(import_glb(maker).meshes.at(0).positions[2] == Vector3f(5, 0, 0));
    const std::uint16_t repeated[] = {1, 1};
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", maker.add_view(repeated, 4)}, {"componentType", 5123}}},
                          {"values", {{"bufferView", value_view}}}};
    CHECK(refusal(maker) == where + "sparse indices must increase and stay below the accessor's count");
  }
  SECTION("a count beyond the accessor's or the view's") {
    accessor["sparse"]["count"] = 4;
    CHECK(refusal(maker) == where + "sparse count or offset is out of range");
    accessor["sparse"]["count"] = 3;
    CHECK(refusal(maker) == where + "3 elements reach beyond the buffer view");
  }
  SECTION("float indices") {
    accessor["sparse"]["indices"]["componentType"] = 5126;
    CHECK(refusal(maker) == where + "sparse indices must be u8, u16 or u32");
  }
}

TEST_CASE("offsets, counts, strides and references out of range are refused") {
  const auto [pointer, value, line] = GENERATE(table<std::string, json, std::string>({
      {"/accessors/0/count", 4,
       "meshes[0].primitives[0].POSITION (accessors[0]): 4 elements reach beyond the buffer view"},
      {"/accessors/0/count", 2147483647,
       "meshes[0].primitives[0].POSITION (accessors[0]): 2147483647 elements reach beyond the buffer view"},
      {"/accessors/0/count", 0, "scene: holds no triangles to draw"},
      {"/accessors/0/byteOffset", 4,
       "meshes[0].primitives[0].POSITION (accessors[0]): 3 elements reach beyond the buffer view"},
      {"/accessors/0/byteOffset", 40,
       "meshes[0].primitives[0].POSITION (accessors[0]): starts beyond bufferViews[0] of 36 bytes"},
      {"/accessors/0/bufferView", 9,
       "meshes[0].primitives[0].POSITION (accessors[0]): buffer view 9 does not exist"},
      {"/accessors/0/componentType", 5124,
       "meshes[0].primitives[0].POSITION (accessors[0]): componentType or type is not one of glTF's"},
      {"/accessors/0/type", "VEC2", "meshes[0].primitives[0].POSITION: must have 3 components, has 2"},
      {"/bufferViews/0/byteLength", 1000, "bufferViews[0]: reaches beyond its buffer of 36 bytes"},
      {"/bufferViews/0/byteOffset", 2147483647, "bufferViews[0]: reaches beyond its buffer of 36 bytes"},
      {"/bufferViews/0/byteStride", 8,
       "meshes[0].primitives[0].POSITION (accessors[0]): byteStride is smaller than one element"},
      {"/bufferViews/0/buffer", 3, "bufferViews[0].buffer: 3 does not exist"},
      {"/meshes/0/primitives/0/attributes/POSITION", 5,
       "meshes[0].primitives[0].POSITION: accessor 5 does not exist"},
      {"/meshes/0/primitives/0/indices", 0,
       "meshes[0].primitives[0].indices: indices must be u8, u16 or u32 scalars"},
      {"/meshes/0/primitives/0/material", 0, "meshes[0].primitives[0].material: 0 does not exist"},
      {"/meshes/0/primitives/0/mode", 7, "meshes[0].primitives[0].mode: 7 is not one of glTF's"},
      {"/nodes/0/mesh", 1, "nodes[0].mesh: 1 does not exist"},
      {"/scene", 1, "scene: 1 does not exist"},
  }));
  GltfMaker maker = one_triangle();
  maker.json[json::json_pointer(pointer)] = value;
  CHECK(refusal(maker) == line);
}

TEST_CASE("a small file that needs terabytes is refused") {
  GltfMaker maker = one_triangle();
  maker.json["accessors"][0].erase("bufferView");  // zeros
  maker.json["accessors"][0]["count"] = 2000000000;
  CHECK(
      refusal(maker) ==
      "meshes[0].primitives[0].POSITION (accessors[0]): the scene would need more than 12288 MiB of vertices "
      "and "
      "texels: split it or shrink its textures");
}

TEST_CASE("missing vertices, differing counts and positions that are not finite are refused") {
  GltfMaker maker = one_square();
  const std::string where = "meshes[0].primitives[0]";
  SECTION("indices") {
    maker.primitive()["indices"] = maker.add(std::vector<std::uint16_t>{0, 1, 4}, 5123, "SCALAR", 3);
    CHECK(refusal(maker) == where + ".indices: vertex 4 of 4 does not exist");
  }
  SECTION("counts") {
    maker.primitive()["attributes"]["NORMAL"] = maker.add_floats({0, 0, 1}, "VEC3");
    CHECK(refusal(maker) == where + ".NORMAL: has 1 elements, POSITION has 4");
  }
  SECTION("not finite") {
    const float bad =
        GENERATE(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity());
    maker.primitive()["attributes"]["POSITION"] =
        maker.add_floats({0, 0, 0, 1, 0, 0, 1, bad, 0, 0, 1, 0}, "VEC3");
    CHECK(refusal(maker) == where + ".POSITION: element 2 is not finite");
  }
  SECTION("integer colours that are not normalised") {
    maker.primitive()["attributes"]["COLOR_0"] = maker.add(std::vector<std::uint8_t>(16), 5121, "VEC4", 4);
    CHECK(refusal(maker) == where + ".COLOR_0: integer colours must be normalized");
  }
}
