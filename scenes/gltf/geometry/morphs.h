#pragma once

#include <span>

#include "scenes/gltf/geometry/attributes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The morph weights of a node at rest: the node's own, else its mesh's. Empty if all are 0.
std::vector<double> rest_weights(const Document& document, const tinygltf::Node& node);

/// Adds the primitive's morph targets, each times its weight (glTF 2.0 §3.7.2.2), to the mesh's positions,
/// normals, tangents and texture coordinates.
void apply_morph_targets(PrimitiveReader& reader, std::span<const double> weights, Mesh& mesh);

}  // namespace cps::gltf
