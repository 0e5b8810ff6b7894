#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// The mesh in the world, for a transform that flattens it and so has no inverse for its normals and for
/// rays. Triangles that become lines are left out.
Mesh flattened(const Mesh& mesh, const Eigen::Affine3f& world_from_mesh);

}  // namespace cps::gltf
