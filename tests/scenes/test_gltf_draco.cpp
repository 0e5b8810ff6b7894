#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <catch2/catch.hpp>
#include <set>
#include <tuple>

#include "random/counter_hash.h"
#include "tests/scenes/gltf_maker.h"

using Catch::Matchers::StartsWith;
using Eigen::Vector3f;

namespace {

constexpr int columns = 9;

Vector3f hill(int x, int y) {
  return {static_cast<float>(x), static_cast<float>(y), 0.25f * x * y};
}

/// A bumpy grid as one_square()'s primitive, compressed by Draco, with the accessors that the specification
/// asks for: counts and types, but no buffer views.
GltfMaker compressed_grid() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2 * (columns - 1) * (columns - 1));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  std::uint32_t face = 0;
  for (int x = 0; x + 1 < columns; ++x)
    for (int y = 0; y + 1 < columns; ++y) {
      const Eigen::Vector2i square[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
      for (const auto& [i, j, k] : {std::tuple(0, 1, 2), std::tuple(0, 2, 3)}) {
        const auto at = [&](int corner) { return hill(square[corner].x(), square[corner].y()); };
        const auto uv_at = [&](int corner) {
          return Eigen::Vector2f(square[corner].cast<float>() / columns);
        };
        builder.SetAttributeValuesForFace(positions, draco::FaceIndex(face), at(i).data(), at(j).data(),
                                          at(k).data());
        builder.SetAttributeValuesForFace(uv, draco::FaceIndex(face), uv_at(i).data(), uv_at(j).data(),
                                          uv_at(k).data());
        ++face;
      }
    }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::EncoderBuffer encoded;
  draco::Encoder encoder;  // no quantisation: nothing is lost
  encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
  if (!encoder.EncodeMeshToBuffer(*mesh, &encoded).ok()) throw std::runtime_error("Draco cannot encode");

  GltfMaker maker;
  const int view = maker.add_view(encoded.data(), encoded.size());
  const std::size_t vertices = columns * columns;
  maker.json["accessors"] = {{{"componentType", 5126}, {"type", "VEC3"}, {"count", vertices}},
                             {{"componentType", 5126}, {"type", "VEC2"}, {"count", vertices}},
                             {{"componentType", 5123}, {"type", "SCALAR"}, {"count", 3 * mesh->num_faces()}}};
  maker.json["meshes"] = {{{"primitives",
                            {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}},
                              {"indices", 2},
                              {"extensions",
                               {{"KHR_draco_mesh_compression",
                                 {{"bufferView", view},
                                  {"attributes",
                                   {{"POSITION", mesh->attribute(positions)->unique_id()},
                                    {"TEXCOORD_0", mesh->attribute(uv)->unique_id()}}}}}}}}}}}};
  maker.json["nodes"] = {{{"mesh", 0}}};
  maker.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return maker;
}

nlohmann::json& draco_extension(GltfMaker& maker) {
  return maker.primitive()["extensions"]["KHR_draco_mesh_compression"];
}

}  // namespace

TEST_CASE("a Draco-compressed primitive comes out as the mesh that went in") {
  const GltfMaker maker = compressed_grid();
  const std::string text = maker.gltf();
  const cps::Mesh mesh = GENERATE(true, false) ? import_glb(maker).meshes.at(0)
                                               : import_bytes({text.begin(), text.end()}).meshes.at(0);
  CHECK(mesh.triangles.size() == 2 * (columns - 1) * (columns - 1));
  // Positions belong to their texture coordinates; each square of the grid is covered by two triangles that
  // face +z.
  std::multiset<std::pair<int, int>> squares;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Vector3f middle = Vector3f::Zero();
    for (const int vertex : triangle) {
      const Vector3f& p = mesh.positions[vertex];
      CHECK(p == hill(static_cast<int>(p.x()), static_cast<int>(p.y())));
      CHECK(mesh.uv0[vertex] == Eigen::Vector2f(p.head<2>() / columns));
      middle += p / 3;
    }
    CHECK(mesh.normals[triangle[0]].z() > 0);
    squares.emplace(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
  }
  for (int x = 0; x + 1 < columns; ++x)
    for (int y = 0; y + 1 < columns; ++y) CHECK(squares.count({x, y}) == 2);
}

TEST_CASE("Draco data that cannot be decoded is named") {
  GltfMaker maker = compressed_grid();
  const std::string where = "meshes[0].primitives[0]";
  SECTION("cut off") {
    maker.json["bufferViews"][0]["byteLength"] = 40;
    CHECK_THAT(refusal(maker), StartsWith(where + ": Draco data cannot be decoded ("));
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
  const GltfMaker original = compressed_grid();
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
