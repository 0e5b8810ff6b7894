#pragma once

#include <span>

#include "scenes/gltf/document/nodes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// Adds the lamps (KHR_lights_punctual) of the placed nodes to the scene. Their candela and lux become kcd
/// and klx. A lamp's `range` is not read: its light falls off with the square of the distance and ends
/// nowhere.
void add_lights(Document& document, std::span<const PlacedNode> placed, Scene& scene);

}  // namespace cps::gltf
