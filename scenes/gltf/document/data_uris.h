#pragma once

#include <nlohmann/json.hpp>

namespace cps::gltf {

/// tinygltf takes data URIs of a few media types only, image/webp not among them: others, which are told by
/// their content here anyway, become application/octet-stream. True when the JSON changed.
bool complete_data_uris(nlohmann::json& root);

}  // namespace cps::gltf
