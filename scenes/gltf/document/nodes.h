#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// A node that belongs to the scene, and where it stands.
struct PlacedNode {
  int node;
  Eigen::Affine3d world_from_node;
};

/// The scene to read: the file's default one, else its first, else −1.
int scene_to_read(const Document& document);

/// All nodes of `scene` (−1: of all trees in the file), parents before children, in the file's order. Refuses
/// nodes that are reached twice (cycles among them) and transforms that are not affine and finite.
std::vector<PlacedNode> place_nodes(const Document& document, int scene);

}  // namespace cps::gltf
