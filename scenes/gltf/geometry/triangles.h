#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// The corners of triangles, three vertex numbers each, from a primitive's indices in TRIANGLES,
/// TRIANGLE_STRIP or TRIANGLE_FAN order. Triangles with a repeated corner (strips are stitched with them) are
/// left out.
std::vector<std::uint32_t> triangle_corners(Document& document, int mode,
                                            std::span<const std::uint32_t> indices, const std::string& where);

/// Triangles over only those vertices that they use: vertex i was vertex `vertices[i]`, in the same order.
struct CompactTriangles {
  std::vector<std::uint32_t> vertices;
  std::vector<Eigen::Vector3i> triangles;
};

/// Many primitives may share one huge vertex buffer: each keeps its own part only.
CompactTriangles compact(Document& document, std::span<const std::uint32_t> corners,
                         const std::string& where);

}  // namespace cps::gltf
