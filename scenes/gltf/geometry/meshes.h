#pragma once

#include <map>
#include <utility>
#include <vector>

#include "scenes/gltf/geometry/primitives.h"
#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// The scene's meshes and which glTF mesh they came from. Only those that nodes really use are made.
struct MeshTable {
  Document& document;
  Scene& scene;
  MaterialTable materials;
  /// glTF mesh and its morph targets' weights → scene's, one for each primitive of triangles
  std::map<std::pair<int, std::vector<double>>, std::vector<int>> shared = {};
};

/// Adds a glTF mesh to the scene, one mesh for each of its primitives of triangles, and returns their
/// indices.
std::vector<int> add_meshes(MeshTable& table, int gltf_mesh, const RestPose& pose);

/// The scene's meshes for a glTF mesh without a skin, added on first use.
const std::vector<int>& shared_meshes(MeshTable& table, int gltf_mesh, const std::vector<double>& weights);

}  // namespace cps::gltf
