#pragma once

#include "scenes/scene.h"

namespace cps {

/// Sets Mesh::is_enclosure of the meshes that together close the sky over the whole scene: domes, sky boxes
/// and halls, whole or in parts, whichever way their faces look. From the middle of the scene, and from two
/// places beside it, they are the last surface in nearly all directions upwards.
void mark_enclosures(Scene& scene);

/// The box around all instances (world) but those of enclosures.
Eigen::AlignedBox3f bounds_without_enclosures(const Scene& scene);

}  // namespace cps
