#pragma once

#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/gltf/document/nodes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The perspective cameras of the placed nodes, in their order, named after the camera or else its node;
/// orthographic ones are left out with a warning. Scaling of nodes does not apply to cameras. Refuses a node
/// whose camera does not exist, a field of view outside (0°, 180°), and a placement that points nowhere.
std::vector<SceneCamera> read_cameras(Document& document, const std::vector<PlacedNode>& nodes);

}  // namespace cps::gltf
