#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// A node of the scene and its transform.
struct PlacedNode {
  int node;
  Eigen::Affine3d world_from_node;
  bool is_visible = true;  ///< as KHR_node_visibility says of it and of the nodes above
};

/// The index of the file's default scene, else 0; −1 if it has no scenes.
int scene_to_read(const Document& document);

/// All nodes of `scene` (−1: of all node trees in the file), parents before children, otherwise in the file's
/// order. Refuses a node that is reached twice (as in a cycle) and a transform that is not affine and finite.
std::vector<PlacedNode> place_nodes(const Document& document, int scene);

/// The middle of the visible meshes, in whole metres, if it lies more than 10 km from the origin; else 0.
Eigen::Vector3d far_origin(const Document& document, const std::vector<PlacedNode>& nodes);

}  // namespace cps::gltf
