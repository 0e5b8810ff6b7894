#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// The corners of a primitive's triangles, three vertex numbers each. `mode` is TRIANGLES, TRIANGLE_STRIP or
/// TRIANGLE_FAN. Drops triangles with a repeated corner, which join strips.
std::vector<std::uint32_t> triangle_corners(Document& document, int mode,
                                            std::span<const std::uint32_t> indices, const std::string& where);

/// Triangles renumbered over the vertices they use; `vertices[i]` is the former number of vertex i
/// (ascending).
struct CompactTriangles {
  std::vector<std::uint32_t> vertices;
  std::vector<Eigen::Vector3i> triangles;
};

/// Drops unused vertices: many primitives may share one huge vertex buffer, and each keeps only its part.
CompactTriangles compact(Document& document, std::span<const std::uint32_t> corners,
                         const std::string& where);

}  // namespace cps::gltf
