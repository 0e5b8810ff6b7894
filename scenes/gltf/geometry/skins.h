#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/gltf/document/nodes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The transform world ← mesh of each joint of a skin in the file's rest pose: the joint node's world
/// transform times its inverse bind matrix. Refuses a skin that does not exist or whose joints are not among
/// `placed`.
std::vector<Eigen::Affine3f> joint_transforms(Document& document, int skin,
                                              std::span<const PlacedNode> placed);

/// Deforms a mesh into the world frame by linear blend skinning: `joints` and `weights` hold four numbers per
/// vertex. Reverses triangles that the joints mirror, so that their front faces stay front faces.
void blend_to_joints(Mesh& mesh, std::span<const Eigen::Vector4f> joints,
                     std::span<const Eigen::Vector4f> weights, std::span<const Eigen::Affine3f> transforms);

}  // namespace cps::gltf
