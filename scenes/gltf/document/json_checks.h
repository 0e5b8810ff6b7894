#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace cps::gltf {

/// Parses the JSON of a glTF file. Refuses, in one line that names the property, what tinygltf would ignore
/// or crash on: deep nesting (tinygltf recurses), numbers of the wrong kind (it silently takes a default),
/// other glTF versions, and required extensions that the importer does not support.
nlohmann::json parse_checked_json(const std::filesystem::path& file, std::string_view text);

}  // namespace cps::gltf
