#pragma once

#include <Eigen/Geometry>
#include <span>
#include <string>

#include "scenes/gltf/materials.h"

namespace cps::gltf {

/// The mesh that a primitive describes, without triangles where it is points or lines (with a warning).
/// Missing or broken normals and tangents are made. With `joint_transforms` (a skin's) it is bent to the
/// world's frame.
Mesh make_mesh(MaterialTable& materials, const tinygltf::Primitive& primitive,
               std::span<const Eigen::Affine3f> joint_transforms, const std::string& where);

}  // namespace cps::gltf
