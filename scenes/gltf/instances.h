#pragma once

#include <span>

#include "scenes/gltf/document/nodes.h"
#include "scenes/gltf/geometry/meshes.h"

namespace cps::gltf {

/// Adds the meshes of the placed nodes to the scene: one instance per primitive, or as many as
/// EXT_mesh_gpu_instancing lists. Skinned meshes take the file's rest pose. Draws nodes with a scale of 0
/// along one axis flat, and skips those with a scale of 0 along two, with a warning.
void add_instances(MeshTable& meshes, std::span<const PlacedNode> placed);

}  // namespace cps::gltf
