#pragma once

#include "renderer/geometry/geometry.h"
#include "scenes/scene.h"

namespace cps {

/// Whether this many placements of a mesh share one copy. Copies of a small mesh are flattened into world
/// coordinates instead, since they trace faster than instances.
bool is_shared(const Mesh& mesh, std::size_t placements);

/// Puts a scene's meshes into the world: shared ones once, the others as copies in world
/// coordinates. Throws std::runtime_error in one line where an index or a number in the scene is wrong.
PlacedGeometry place_geometry(const Scene& scene, const Materials& materials);

}  // namespace cps
