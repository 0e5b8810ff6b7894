#pragma once

#include <map>
#include <utility>
#include <vector>

#include "scenes/gltf/geometry/primitives.h"
#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// Makes the scene's meshes from the glTF meshes that nodes use, and remembers which came from which.
struct MeshTable {
  Document& document;
  Scene& scene;
  MaterialTable materials;
  /// (glTF mesh, morph weights) → the scene's meshes, one per triangle primitive
  std::map<std::pair<int, std::vector<double>>, std::vector<int>> shared = {};
};

/// Adds a glTF mesh to the scene as one mesh per triangle primitive, and returns their indices.
std::vector<int> add_meshes(MeshTable& table, int gltf_mesh, const RestPose& pose);

/// Indices of the scene's meshes for a glTF mesh without a skin; adds them on first use.
const std::vector<int>& shared_meshes(MeshTable& table, int gltf_mesh, const std::vector<double>& weights);

}  // namespace cps::gltf
