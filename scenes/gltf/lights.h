#pragma once

#include <span>

#include "scenes/gltf/document/nodes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// Adds the lights (KHR_lights_punctual) of the placed nodes to the scene, converting candela and lux to kcd
/// and klx. Ignores `range`: light falls off with the square of the distance without a cut-off.
void add_lights(Document& document, std::span<const PlacedNode> placed, Scene& scene);

}  // namespace cps::gltf
