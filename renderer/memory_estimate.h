#pragma once

#include <cstddef>

#include "scenes/scene.h"

namespace cps {

/// Estimated peak memory, in bytes, for building and rendering this scene: the scene itself; vertices,
/// triangles and textures as the tracer stores them; and Embree's BVH by a measured figure per triangle. Lets
/// callers refuse a scene that does not fit before it is built. Unchecked: the scene's indices must be in
/// range.
std::size_t estimated_bytes(const Scene& scene);

}  // namespace cps
