#include "tests/scenes/gltf/draco_grid.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <tuple>

using Eigen::Vector3f;

Vector3f grid_point(int x, int y) {
  return {static_cast<float>(x), static_cast<float>(y), 0.25f * x * y};
}

GltfMaker draco_grid() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2 * (grid_columns - 1) * (grid_columns - 1));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  std::uint32_t face = 0;
  for (int x = 0; x + 1 < grid_columns; ++x)
    for (int y = 0; y + 1 < grid_columns; ++y) {
      const Eigen::Vector2i square[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
      for (const auto& [i, j, k] : {std::tuple(0, 1, 2), std::tuple(0, 2, 3)}) {
        const auto at = [&](int corner) { return grid_point(square[corner].x(), square[corner].y()); };
        const auto uv_at = [&](int corner) {
          return Eigen::Vector2f(square[corner].cast<float>() / grid_columns);
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
  const std::size_t vertices = grid_columns * grid_columns;
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
