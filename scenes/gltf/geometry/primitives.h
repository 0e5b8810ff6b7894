#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scenes/gltf/materials/materials.h"

namespace cps::gltf {

/// What bends a mesh when nothing is animated.
struct RestPose {
  std::vector<double> weights;                    ///< of its morph targets
  std::vector<Eigen::Affine3f> joint_transforms;  ///< a skin's; empty without one
};

/// The mesh that a primitive describes, without triangles where it is points or lines (with a warning).
/// Missing or broken normals and tangents are made. Morph targets are applied with `pose`'s weights; with its
/// joint transforms the mesh is bent to the world's frame.
Mesh make_mesh(MaterialTable& materials, const tinygltf::Primitive& primitive, const RestPose& pose,
               const std::string& where);

}  // namespace cps::gltf
