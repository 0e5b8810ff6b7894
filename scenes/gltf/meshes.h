#pragma once

#include <Eigen/Geometry>
#include <map>
#include <span>
#include <vector>

#include "scenes/gltf/materials.h"

namespace cps::gltf {

/// Turns the glTF meshes that nodes really use into the scene's, each once.
struct MeshTable {
  Document& document;
  Scene& scene;
  MaterialTable materials;
  std::map<int, std::vector<int>> meshes;  ///< glTF mesh → scene's, one per primitive
};

/// The scene's meshes for a glTF mesh: one for each of its primitives that are triangles. Points and lines
/// are left out with a warning; missing or broken normals and tangents are made.
const std::vector<int>& mesh_indices(MeshTable& table, int gltf_mesh);

/// The same, bent to the world's frame by a skin's joint transforms: made anew at each call.
std::vector<int> skinned_mesh(MeshTable& table, int gltf_mesh,
                              std::span<const Eigen::Affine3f> joint_transforms);

}  // namespace cps::gltf
