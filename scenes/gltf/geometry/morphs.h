#pragma once

#include <span>

#include "scenes/gltf/document/attributes.h"
#include "scenes/scene.h"

namespace cps::gltf {

/// The weights that a node's mesh is drawn with at rest: the node's, else the mesh's; empty where all are 0.
std::vector<double> rest_weights(const Document& document, const tinygltf::Node& node);

/// Adds the primitive's morph targets, each times its weight (glTF 2.0 §3.7.2.2), to positions, normals,
/// tangents and texture coordinates.
void apply_morph_targets(PrimitiveReader& reader, std::span<const double> weights, Mesh& mesh);

}  // namespace cps::gltf
