#pragma once

#include <cstddef>

#include "scenes/scene.h"

namespace cps {

/// Bytes that building and rendering this scene will take at most, the scene itself included: vertices,
/// triangles and textures as the tracer holds them beside the scene's own, and Embree's BVH by a guess.
/// For refusing what does not fit before it is built. Unchecked: the scene's indices must be in range.
std::size_t estimated_bytes(const Scene& scene);

}  // namespace cps
