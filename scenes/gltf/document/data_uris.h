#pragma once

#include <nlohmann/json.hpp>

namespace cps::gltf {

/// Renames the media type of data URIs that tinygltf would refuse (image/webp is one) to
/// application/octet-stream; the importer recognises images by content anyway.
void complete_data_uris(nlohmann::json& root);

}  // namespace cps::gltf
