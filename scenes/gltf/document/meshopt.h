#pragma once

#include <nlohmann/json.hpp>

#include "scenes/gltf/document/document.h"

/// EXT_meshopt_compression: buffer views whose bytes libmeshoptimizer decodes.
namespace cps::gltf {

/// Gives fallback buffers, which stand for what is decoded and may have no data, a byte: tinygltf refuses
/// buffers without data.
void complete_meshopt_buffers(nlohmann::json& root);

/// Decodes the compressed buffer views into new buffers of the document.
void decode_meshopt_views(Document& document);

}  // namespace cps::gltf
