#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// How a mesh is deformed while nothing is animated.
struct RestPose {
  std::vector<double> weights;                    ///< of the morph targets
  std::vector<Eigen::Affine3f> joint_transforms;  ///< of the skin; empty without one
};

/// Makes a mesh of a primitive; points and lines give a mesh without triangles and a warning. Makes normals
/// and tangents that are missing or broken. Applies the morph targets with the weights of `pose`; if `pose`
/// has joint transforms, the mesh is deformed by them into the world frame.
Mesh make_mesh(MaterialTable& materials, const tinygltf::Primitive& primitive, const RestPose& pose,
               const std::string& where);

}  // namespace cps::gltf
