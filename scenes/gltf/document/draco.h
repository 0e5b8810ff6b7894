#pragma once

#include <nlohmann/json.hpp>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// tinygltf refuses index accessors without a buffer view, which compressed primitives rightly have: gives
/// them the compressed data's. True when the JSON changed.
bool complete_draco_accessors(nlohmann::json& root);

/// A primitive with KHR_draco_mesh_compression as one without: decoded into a new buffer of the document,
/// with new accessors. Others come back as they are.
tinygltf::Primitive without_draco(Document& document, const tinygltf::Primitive& primitive,
                                  const std::string& where);

}  // namespace cps::gltf
