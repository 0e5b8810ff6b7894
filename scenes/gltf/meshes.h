#pragma once

#include <Eigen/Geometry>
#include <map>
#include <span>
#include <vector>

#include "scenes/gltf/materials.h"

namespace cps::gltf {

/// The scene's meshes and which glTF mesh they came from. Only those that nodes really use are made.
struct MeshTable {
  Document& document;
  Scene& scene;
  MaterialTable materials;
  std::map<int, std::vector<int>> shared = {};  ///< glTF mesh → scene's, one for each primitive of triangles
};

/// Adds a glTF mesh to the scene, one mesh for each of its primitives of triangles, and returns their
/// indices. With `joint_transforms` (a skin's) it is bent to the world's frame.
std::vector<int> add_meshes(MeshTable& table, int gltf_mesh,
                            std::span<const Eigen::Affine3f> joint_transforms);

/// The scene's meshes for a glTF mesh without a skin, added on first use.
const std::vector<int>& shared_meshes(MeshTable& table, int gltf_mesh);

}  // namespace cps::gltf
