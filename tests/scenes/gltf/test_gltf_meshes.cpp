#include <catch2/catch.hpp>
#include <cmath>

#include "tests/scenes/gltf/gltf_maker.h"

using Eigen::Vector3f;
using Eigen::Vector3i;
using Eigen::Vector4f;
using nlohmann::json;

namespace {

/// A square with a normal map and without tangents, so that the importer makes them.
GltfMaker square_with_normal_map() {
  GltfMaker maker = one_square();
  const int texture = maker.add_texture(encode_image("png", 1, 1, 3, {128, 128, 255}));
  maker.json["materials"][0]["normalTexture"] = {{"index", texture}};
  return maker;
}

}  // namespace

TEST_CASE("strips and fans have the winding of lists") {
  GltfMaker maker = one_square();  // corners anticlockwise: 0 1 2 3
  SECTION("strip") {
    maker.primitive()["mode"] = 5;
    maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 3, 2}, 5121, "SCALAR", 4);
    CHECK(import_glb(maker).meshes.at(0).triangles == std::vector<Vector3i>{{0, 1, 3}, {1, 2, 3}});
  }
  SECTION("a strip stitched with repeated corners") {
    maker.primitive()["mode"] = 5;
    maker.primitive()["indices"] =
        maker.add(std::vector<std::uint8_t>{0, 1, 3, 3, 3, 1, 2}, 5121, "SCALAR", 7);
    CHECK(import_glb(maker).meshes.at(0).triangles == std::vector<Vector3i>{{0, 1, 3}, {3, 1, 2}});
  }
  SECTION("fan") {
    maker.primitive()["mode"] = 6;
    maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 2, 3}, 5121, "SCALAR", 4);
    CHECK(import_glb(maker).meshes.at(0).triangles == std::vector<Vector3i>{{1, 2, 0}, {2, 3, 0}});
  }
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  for (const Vector3i& triangle : mesh.triangles) {
    const Vector3f a = mesh.positions[triangle[0]];
    CHECK((mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a).z() > 0);
  }
}

TEST_CASE("strips and fans without indices use the vertices in order") {
  GltfMaker maker = one_square();
  maker.primitive().erase("indices");
  maker.primitive()["mode"] = 5;
  CHECK(import_glb(maker).meshes.at(0).triangles == std::vector<Vector3i>{{0, 1, 2}, {1, 3, 2}});
  maker.primitive()["mode"] = 6;
  CHECK(import_glb(maker).meshes.at(0).triangles == std::vector<Vector3i>{{1, 2, 0}, {2, 3, 0}});
}

TEST_CASE("the largest index of each type, which restarts primitives, is refused even if its vertex exists") {
  GltfMaker maker;
  const std::size_t count = 65536;
  maker.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", maker.add_floats(std::vector<float>(3 * count, 1), "VEC3")}}}}}}}};
  maker.json["nodes"] = {{{"mesh", 0}}};
  const std::string where = "meshes[0].primitives[0].indices: ";
  maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 255}, 5121, "SCALAR", 3);
  CHECK(refusal(maker) == where + "255 restarts primitives, which glTF does not have");
  maker.primitive()["indices"] = maker.add(std::vector<std::uint16_t>{0, 1, 65535}, 5123, "SCALAR", 3);
  CHECK(refusal(maker) == where + "65535 restarts primitives, which glTF does not have");
  maker.primitive()["indices"] = maker.add(std::vector<std::uint32_t>{0, 1, 4294967295}, 5125, "SCALAR", 3);
  CHECK(refusal(maker) == where + "4294967295 restarts primitives, which glTF does not have");
  maker.primitive()["indices"] = maker.add(std::vector<std::uint32_t>{0, 1, 65535}, 5125, "SCALAR", 3);
  CHECK(import_glb(maker).meshes.at(0).positions.size() == 3);
}

TEST_CASE("a number of corners that is no multiple of three is refused") {
  GltfMaker maker = one_square();
  maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 2, 3}, 5121, "SCALAR", 4);
  CHECK(refusal(maker) == "meshes[0].primitives[0]: 4 corners do not make whole triangles");
}

TEST_CASE("points and lines are skipped with a warning, a file of nothing else is refused") {
  GltfMaker maker = one_triangle();
  json line = maker.primitive();
  line["mode"] = GENERATE(0, 1, 2, 3);
  maker.json["meshes"][0]["primitives"].push_back(line);
  std::vector<std::string> warnings;
  CHECK(import_glb(maker, &warnings).meshes.size() == 1);
  CHECK(warnings == std::vector<std::string>{"meshes[0].primitives[1]: points and lines are not drawn"});
  maker.json["meshes"][0]["primitives"] = {line};
  CHECK(refusal(maker) == "scene: holds no triangles to draw");
}

TEST_CASE("a primitive keeps only the vertices it uses of a shared buffer") {
  GltfMaker maker = one_square();
  json second = maker.primitive();
  maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 2}, 5121, "SCALAR", 3);
  second["indices"] = maker.add(std::vector<std::uint8_t>{0, 2, 3}, 5121, "SCALAR", 3);
  maker.json["meshes"][0]["primitives"].push_back(second);
  const cps::Scene scene = import_glb(maker);
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.instances.size() == 2);
  CHECK(scene.meshes[1].positions == std::vector<Vector3f>{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(scene.meshes[1].uv0 == std::vector<Eigen::Vector2f>{{0, 1}, {1, 0}, {0, 0}});
  CHECK(scene.meshes[1].triangles == std::vector<Vector3i>{{0, 1, 2}});
}

TEST_CASE("missing normals become flat ones, with separate vertices for adjacent faces") {
  GltfMaker maker = one_square();
  json& attributes = maker.primitive()["attributes"];
  attributes.erase("NORMAL");
  attributes["POSITION"] =
      maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1}, "VEC3");  // folded along 0–2
  attributes["TANGENT"] = maker.add_floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.positions.size() == 6);
  CHECK(mesh.triangles == std::vector<Vector3i>{{0, 1, 2}, {3, 4, 5}});
  CHECK(mesh.tangents.empty());  // the specification says to ignore them
  const float half = std::sqrt(0.5f);
  for (int i = 0; i < 3; ++i) {
    CHECK(mesh.normals[i] == Vector3f(0, 0, 1));
    CHECK(mesh.normals[3 + i].isApprox(Vector3f(half, -half, 0)));
  }
  CHECK(mesh.uv0[5] == Eigen::Vector2f(0, 0));
}

TEST_CASE("normals are normalised, broken ones replaced by those of their triangles") {
  GltfMaker maker = one_square();
  maker.primitive()["attributes"]["NORMAL"] =
      maker.add_floats({0, 0, 5, 0, 0, 0, std::nanf(""), 0, 1, 3, 0, 4}, "VEC3");
  std::vector<std::string> warnings;
  const cps::Mesh mesh = import_glb(maker, &warnings).meshes.at(0);
  CHECK(mesh.normals[0] == Vector3f(0, 0, 1));
  CHECK(mesh.normals[1] == Vector3f(0, 0, 1));
  CHECK(mesh.normals[2] == Vector3f(0, 0, 1));
  CHECK(mesh.normals[3].isApprox(Vector3f(0.6f, 0, 0.8f)));
  CHECK(warnings ==
        std::vector<std::string>{"meshes[0].primitives[0].NORMAL: 2 are zero or not finite, made anew"});
}

TEST_CASE("a square with u to the right and v down has tangent +x and handedness +1") {
  const GltfMaker maker = square_with_normal_map();
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  REQUIRE(mesh.tangents.size() == 4);
  for (const Vector4f& tangent : mesh.tangents) CHECK(tangent.isApprox(Vector4f(1, 0, 0, 1)));
}

TEST_CASE("tangents follow turned and mirrored texture coordinates and transforms") {
  GltfMaker maker = square_with_normal_map();
  json& uv = maker.primitive()["attributes"]["TEXCOORD_0"];
  SECTION("u up, v to the right") {
    uv = maker.add_floats({0, 0, 0, 1, 1, 1, 1, 0}, "VEC2");
    // A quarter turn, not a mirror: the bitangent −∂p/∂v = −x is still n × t.
    CHECK(import_glb(maker).meshes.at(0).tangents[0].isApprox(Vector4f(0, 1, 0, 1)));
  }
  SECTION("u to the left") {
    uv = maker.add_floats({1, 1, 0, 1, 0, 0, 1, 0}, "VEC2");
    CHECK(import_glb(maker).meshes.at(0).tangents[0].isApprox(Vector4f(-1, 0, 0, -1)));
  }
  SECTION("turned by KHR_texture_transform") {
    maker.json["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"] = {
        {"rotation", std::acos(-1.0) / 2}};
    // u' = v: the texture's u runs down the square.
    CHECK((import_glb(maker).meshes.at(0).tangents[0] - Vector4f(0, -1, 0, 1)).norm() < 1e-6f);
  }
  SECTION("no area in uv") {
    uv = maker.add_floats({0, 0, 0, 0, 0, 0, 0, 0}, "VEC2");
    const Vector4f tangent = import_glb(maker).meshes.at(0).tangents[0];
    CHECK(tangent.head<3>().norm() == Approx(1));
    CHECK(tangent.z() == 0);
  }
}

TEST_CASE("a vertex between mirrored and unmirrored texture coordinates is split") {
  // A butterfly: u runs to the right on the left half and back on the right half.
  GltfMaker maker = square_with_normal_map();
  json& attributes = maker.primitive()["attributes"];
  attributes["POSITION"] = maker.add_floats({-1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  attributes["TEXCOORD_0"] = maker.add_floats({0, 1, 1, 1, 0, 1, 1, 0}, "VEC2");
  maker.primitive()["indices"] = maker.add(std::vector<std::uint8_t>{0, 1, 3, 1, 2, 3}, 5121, "SCALAR", 6);
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.positions.size() == 6);
  CHECK(mesh.normals.size() == 6);
  CHECK(mesh.uv0.size() == 6);
  for (const int corner : mesh.triangles[0]) CHECK(mesh.tangents[corner].isApprox(Vector4f(1, 0, 0, 1)));
  for (const int corner : mesh.triangles[1]) CHECK(mesh.tangents[corner].isApprox(Vector4f(-1, 0, 0, -1)));
  const auto at = [&](int triangle, int corner) { return mesh.positions[mesh.triangles[triangle][corner]]; };
  CHECK(at(1, 0) == Vector3f(0, 0, 0));
  CHECK(at(1, 2) == Vector3f(0, 1, 0));
}

TEST_CASE("vertices repeated per triangle get the same tangents as shared ones") {
  GltfMaker maker = square_with_normal_map();
  json& attributes = maker.primitive()["attributes"];
  // With sheared coordinates the tangents of the two triangles differ, and vertices on the diagonal average
  // both.
  attributes["TEXCOORD_0"] = maker.add_floats({0, 1, 1, 1, 1, 0, 0.5f, 0.2f}, "VEC2");
  const cps::Mesh shared = import_glb(maker).meshes.at(0);
  attributes["POSITION"] = maker.add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
  attributes["NORMAL"] = maker.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  attributes["TEXCOORD_0"] = maker.add_floats({0, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0.5f, 0.2f}, "VEC2");
  maker.primitive().erase("indices");
  const cps::Mesh repeated = import_glb(maker).meshes.at(0);
  REQUIRE(repeated.tangents.size() == 6);
  for (int t = 0; t < 2; ++t)
    for (int c = 0; c < 3; ++c)
      CHECK(repeated.tangents[3 * t + c].isApprox(shared.tangents[shared.triangles[t][c]]));
  CHECK_FALSE(repeated.tangents[1].isApprox(repeated.tangents[5], 0.1f));
}

TEST_CASE("tangents of a cylinder run around its circles") {
  GltfMaker maker = square_with_normal_map();
  constexpr int sides = 64;
  std::vector<float> positions, normals, uv;
  std::vector<std::uint16_t> indices;
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2 * std::acos(-1.0f) * i / sides;
    for (int top = 0; top < 2; ++top) {
      positions.insert(positions.end(), {std::cos(angle), static_cast<float>(top), -std::sin(angle)});
      normals.insert(normals.end(), {std::cos(angle), 0, -std::sin(angle)});
      uv.insert(uv.end(), {static_cast<float>(i) / sides, static_cast<float>(1 - top)});
    }
  }
  for (int i = 0; i < sides; ++i)
    for (const int corner : {0, 2, 3, 0, 3, 1}) indices.push_back(static_cast<std::uint16_t>(2 * i + corner));
  json& attributes = maker.primitive()["attributes"];
  attributes["POSITION"] = maker.add_floats(positions, "VEC3");
  attributes["NORMAL"] = maker.add_floats(normals, "VEC3");
  attributes["TEXCOORD_0"] = maker.add_floats(uv, "VEC2");
  maker.primitive()["indices"] = maker.add(indices, 5123, "SCALAR", indices.size());
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  for (std::size_t i = 2; i + 2 < mesh.positions.size();
       ++i) {  // vertices at the seam have triangles on one side only
    const Vector3f& p = mesh.positions[i];
    CHECK((mesh.tangents[i] - Vector4f(p.z(), 0, -p.x(), 1)).norm() < 1e-3f);
  }
}

TEST_CASE("the file's tangents are kept, broken ones replaced") {
  GltfMaker maker = square_with_normal_map();
  json& attributes = maker.primitive()["attributes"];
  std::vector<std::string> warnings;
  attributes["TANGENT"] = maker.add_floats({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, "VEC4");
  CHECK(import_glb(maker, &warnings).meshes.at(0).tangents[0] == Vector4f(0, 1, 0, -1));
  CHECK(warnings.empty());
  attributes["TANGENT"] = maker.add_floats({0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, "VEC4");
  CHECK(import_glb(maker, &warnings).meshes.at(0).tangents[0].isApprox(Vector4f(1, 0, 0, 1)));
  CHECK(warnings == std::vector<std::string>{"meshes[0].primitives[0].TANGENT: not valid, made anew"});
}

TEST_CASE("morph targets are applied with the node's weights, else the mesh's") {
  GltfMaker maker = one_triangle();
  const int raise = maker.add_floats({0, 0, 1, 0, 0, 2, 0, 0, 3}, "VEC3");
  const int widen = maker.add_floats({0, 0, 0, 5, 0, 0, 0, 0, 0}, "VEC3");
  maker.primitive()["targets"] = {{{"POSITION", raise}}, {{"POSITION", widen}}};
  CHECK(import_glb(maker).meshes.at(0).positions[2] == Vector3f(0, 1, 0));
  maker.json["meshes"][0]["weights"] = {0.5, 0};
  CHECK(import_glb(maker).meshes.at(0).positions ==
        std::vector<Vector3f>{{0, 0, 0.5f}, {1, 0, 1}, {0, 1, 1.5f}});
  maker.json["nodes"] = {
      {{"mesh", 0}}, {{"mesh", 0}, {"weights", {0, 1}}}, {{"mesh", 0}, {"weights", {0.5, 0}}}};
  maker.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
  const cps::Scene scene = import_glb(maker);
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.meshes[1].positions[1] == Vector3f(6, 0, 0));
  CHECK(scene.instances[2].mesh == 0);
  maker.json["nodes"][1]["weights"] = {0, 1e300};
  CHECK(refusal(maker) == "meshes[0].primitives[0].POSITION: is not finite in the rest pose");
  maker.json["nodes"][1]["weights"] = {0, 1};
  maker.primitive()["targets"][1]["POSITION"] = 99;
  CHECK(refusal(maker) == "meshes[0].primitives[0].targets[1].POSITION: accessor 99 does not exist");
}

TEST_CASE("vertex colours and the second set of texture coordinates") {
  GltfMaker maker = one_square();
  json& attributes = maker.primitive()["attributes"];
  attributes["COLOR_0"] = maker.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0.5, 0.5}, "VEC3");
  attributes["TEXCOORD_1"] = maker.add_floats({0, 0, 2, 0, 2, 2, 0, 2}, "VEC2");
  const cps::Mesh mesh = import_glb(maker).meshes.at(0);
  CHECK(mesh.colors[3] == Vector4f(0.5f, 0.5f, 0.5f, 1));
  CHECK(mesh.uv1[2] == Eigen::Vector2f(2, 2));
  CHECK(mesh.material == 0);
}

TEST_CASE("a mesh without the coordinates that its textures need gets zeros and a warning") {
  GltfMaker maker = square_with_normal_map();
  maker.json["materials"][0]["normalTexture"]["texCoord"] = 1;
  std::vector<std::string> warnings;
  const cps::Mesh mesh = import_glb(maker, &warnings).meshes.at(0);
  CHECK(mesh.uv1.size() == mesh.positions.size());
  CHECK(
      warnings ==
      std::vector<std::string>{
          "meshes[0].primitives[0]: its material's textures need texture coordinates that it does not have"});
}
