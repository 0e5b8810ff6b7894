#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// A node of the scene and its transform.
struct PlacedNode {
  int node;
  Eigen::Affine3d world_from_node;
};

/// The index of the file's default scene, else 0; −1 if it has no scenes.
int scene_to_read(const Document& document);

/// All nodes of `scene` (−1: of all node trees in the file), parents before children, otherwise in the file's
/// order. Refuses a node that is reached twice (as in a cycle) and a transform that is not affine and finite.
std::vector<PlacedNode> place_nodes(const Document& document, int scene);

}  // namespace cps::gltf
