#pragma once

#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/gltf/document/nodes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The perspective cameras of the placed nodes, in their order, named after the camera, else after the node.
/// Skips orthographic cameras with a warning. Ignores the scale of nodes. Refuses a camera that does not
/// exist, a field of view outside (0°, 180°), and a transform without a viewing direction.
std::vector<SceneCamera> read_cameras(Document& document, const std::vector<PlacedNode>& nodes);

}  // namespace cps::gltf
