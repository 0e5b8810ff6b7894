#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// Gives every triangle its own vertices with its geometric normal, and drops the tangents, as glTF 2.0
/// §3.7.2.1 requires for meshes without normals.
void make_flat_normals(Mesh& mesh);

/// Normalises the normals. Replaces those that are zero or not finite by the area-weighted mean of their
/// triangles' normals, and returns how many it replaced.
std::size_t repair_normals(Mesh& mesh);

}  // namespace cps::gltf
