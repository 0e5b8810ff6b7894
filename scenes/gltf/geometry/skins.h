#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/gltf/document/nodes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// World ← mesh for each joint of a skin in the file's rest pose: where the joint's node stands times its
/// inverse bind matrix.
std::vector<Eigen::Affine3f> joint_transforms(Document& document, int skin,
                                              std::span<const PlacedNode> placed);

/// Bends a mesh to the world's frame by linear blending: `joints` and `weights` have four numbers per vertex.
/// Triangles that the joints mirror are turned over, so that their fronts stay in front.
void blend_to_joints(Mesh& mesh, std::span<const Eigen::Vector4f> joints,
                     std::span<const Eigen::Vector4f> weights, std::span<const Eigen::Affine3f> transforms);

}  // namespace cps::gltf
