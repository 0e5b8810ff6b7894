#include <catch2/catch.hpp>
#include <set>

#include "random/counter_hash.h"
#include "tests/scenes/gltf/draco_grid.h"

using Catch::Matchers::StartsWith;
using Eigen::Vector3f;

namespace {

nlohmann::json& draco_extension(GltfMaker& maker) {
  return maker.primitive()["extensions"]["KHR_draco_mesh_compression"];
}

}  // namespace

TEST_CASE("a Draco-compressed primitive decodes to the original mesh") {
  const GltfMaker maker = draco_grid();
  const std::string text = maker.gltf();
  const cps::Mesh mesh = GENERATE(true, false) ? import_glb(maker).meshes.at(0)
                                               : import_bytes({text.begin(), text.end()}).meshes.at(0);
  CHECK(mesh.triangles.size() == 2 * (grid_columns - 1) * (grid_columns - 1));
  // Each position has its texture coordinates, and each square of the grid has two triangles that face +z.
  std::multiset<std::pair<int, int>> squares;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Vector3f middle = Vector3f::Zero();
    for (const int vertex : triangle) {
      const Vector3f& p = mesh.positions[vertex];
      CHECK(p == grid_point(static_cast<int>(p.x()), static_cast<int>(p.y())));
      CHECK(mesh.uv0[vertex] == Eigen::Vector2f(p.head<2>() / grid_columns));
      middle += p / 3;
    }
    CHECK(mesh.normals[triangle[0]].z() > 0);
    squares.emplace(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
  }
  for (int x = 0; x + 1 < grid_columns; ++x)
    for (int y = 0; y + 1 < grid_columns; ++y) CHECK(squares.count({x, y}) == 2);
}

TEST_CASE("Draco data that cannot be decoded is refused by name") {
  GltfMaker maker = draco_grid();
  const std::string where = "meshes[0].primitives[0]";
  SECTION("cut off") {
    maker.json["bufferViews"][0]["byteLength"] = 40;
    CHECK_THAT(refusal(maker), StartsWith(where + ": Draco data cannot be decoded ("));
  }
  SECTION("another bitstream") {
    maker.buffer[6] = 1;
    CHECK(refusal(maker) == where + ": Draco data cannot be decoded (its bitstream is 2.1, glTF's is 2.2)");
  }
  SECTION("a claim of 268 million faces in a few bytes") {
    const unsigned char claim[] = {0xff, 0xff, 0xff, 0x7f};  // a varint, after header, traversal and vertices
    std::copy(std::begin(claim), std::end(claim), maker.buffer.begin() + 13);
    CHECK_THAT(refusal(maker), StartsWith(where + ": the scene would need more than 12288 MiB"));
  }
  SECTION("not Draco") {
    maker.buffer[0] = 'X';
    CHECK_THAT(refusal(maker), StartsWith(where + ": Draco data cannot be decoded ("));
  }
  SECTION("no such view") {
    draco_extension(maker)["bufferView"] = 3;
    CHECK(refusal(maker) == "glTF: accessor[2] invalid bufferView");
    maker.primitive().erase("indices");
    CHECK(refusal(maker) == where + ": buffer view 3 does not exist");
  }
  SECTION("no such attribute") {
    draco_extension(maker)["attributes"]["POSITION"] = 77;
    CHECK(refusal(maker) == where + ".POSITION: Draco attribute 77 does not exist");
  }
  SECTION("an attribute that the primitive does not have") {
    maker.primitive()["attributes"].erase("TEXCOORD_0");
    CHECK(refusal(maker) ==
          where + ".TEXCOORD_0: Draco attributes must be attributes of their primitive, too");
  }
  SECTION("no attributes") {
    draco_extension(maker).erase("attributes");
    CHECK(refusal(maker) == where + ".KHR_draco_mesh_compression: must have a bufferView and attributes");
  }
}

TEST_CASE("2,000 mutations of Draco data are decoded or refused in one line") {
  const GltfMaker original = draco_grid();
  int decoded = 0, refused = 0;
  for (int i = 0; i < 2000; ++i) {
    GltfMaker maker = original;
    const cps::Stream stream = cps::substream(cps::make_stream(2, "draco"), i);
    for (int k = 0; k < 2; ++k)
      maker.buffer[cps::random_below(stream, 2 * k, maker.buffer.size())] =
          static_cast<unsigned char>(cps::random_below(stream, 2 * k + 1, 256));
    const std::string line = refusal(maker);
    CHECK(line.find('\n') == line.npos);
    ++(line.empty() ? decoded : refused);
  }
  CHECK(decoded > 200);
  CHECK(refused > 200);
}
