#pragma once

#include <vector>

#include "scenes/gltf/document/document.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The lanes in `extras.cps_lanes` of a glTF scene, less `origin` (Scene::origin) (−1: no scene, no lanes).
/// Refuses a lane without a street name, or with control characters in it; a width outside 1 to 20 m; fewer
/// than two points, points that are not finite or repeat their predecessor; `next` that is no list of lane
/// numbers; `occupied` that is no list of ascending pairs of metres.
std::vector<Lane> read_lanes(const Document& document, int scene, const Eigen::Vector3d& origin);

}  // namespace cps::gltf
