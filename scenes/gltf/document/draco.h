#pragma once

#include <nlohmann/json.hpp>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// Gives the index accessors of compressed primitives the buffer view of the compressed data: they rightly
/// have none, but tinygltf refuses such accessors.
void complete_draco_accessors(nlohmann::json& root);

/// Decodes a primitive with KHR_draco_mesh_compression into new buffers and accessors of the document, and
/// returns it without the extension. Returns other primitives as they are.
tinygltf::Primitive without_draco(Document& document, const tinygltf::Primitive& primitive,
                                  const std::string& where);

}  // namespace cps::gltf
