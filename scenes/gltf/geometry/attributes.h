#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/gltf/document/accessors.h"

namespace cps::gltf {

/// A primitive, and the accessor elements that become the mesh's vertices.
struct PrimitiveReader {
  Document& document;
  const tinygltf::Primitive& primitive;
  std::string where;
  std::vector<std::uint32_t> vertices;
  std::size_t vertex_count;  ///< in the accessors, unused ones included
  std::array<std::string, 2> uv_names = {"TEXCOORD_0", "TEXCOORD_1"};  ///< what becomes uv0 and uv1
};

/// An attribute's vectors, one per vertex of the mesh; empty if the primitive lacks it. Refuses an attribute
/// that has not as many elements as POSITION.
template <int N>
std::vector<Eigen::Matrix<float, N, 1>> read_attribute(PrimitiveReader& reader, const std::string& name) {
  const auto found = reader.primitive.attributes.find(name);
  if (found == reader.primitive.attributes.end()) return {};
  const std::string where = reader.where + "." + name;
  const Elements from = elements(reader.document, found->second, where);
  if (from.count != reader.vertex_count)
    refuse(reader.document, where,
           "has " + std::to_string(from.count) + " elements, POSITION has " +
               std::to_string(reader.vertex_count));
  return read_vectors<N>(reader.document, from, where, reader.vertices);
}

template <int N>
std::vector<Eigen::Matrix<float, N, 1>> read_finite_attribute(PrimitiveReader& reader,
                                                              const std::string& name) {
  auto vectors = read_attribute<N>(reader, name);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    if (!vectors[i].allFinite())
      refuse(reader.document, reader.where + "." + name,
             "element " + std::to_string(reader.vertices[i]) + " is not finite");
  return vectors;
}

/// COLOR_0 (RGB or RGBA) as linear RGBA, one per vertex; empty without it.
std::vector<Eigen::Vector4f> read_colors(PrimitiveReader& reader);

}  // namespace cps::gltf
