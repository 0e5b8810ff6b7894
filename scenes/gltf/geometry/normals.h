#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// Gives every triangle its own vertices and its geometric normal, and drops the tangents: what glTF 2.0
/// §3.7.2.1 asks for where normals are missing.
void make_flat_normals(Mesh& mesh);

/// Normalises the normals; those that are not finite or have no length become the area-weighted mean of their
/// triangles' normals. Returns how many had to be replaced.
std::size_t repair_normals(Mesh& mesh);

}  // namespace cps::gltf
