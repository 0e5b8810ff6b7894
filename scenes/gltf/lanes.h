#pragma once

#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The lanes in `extras.cps_lanes` of a glTF scene (−1: none), checked: a street's name, a width of 1 to 20
/// m, two or more finite points that do not repeat, `next`, if there, a list of lane numbers, and `occupied`,
/// if there, a list of ascending pairs of metres.
std::vector<Lane> read_lanes(const Document& document, int scene);

}  // namespace cps::gltf
