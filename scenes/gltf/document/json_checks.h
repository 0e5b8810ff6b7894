#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace cps::gltf {

/// Parses the JSON of a glTF file and refuses, in one line by name, what tinygltf would pass over in silence
/// or trip over: deep nesting (it recurses), numbers of the wrong kind (it takes a default), another glTF
/// version, and extensions that are required but not read here.
nlohmann::json parse_checked_json(const std::filesystem::path& file, std::string_view text);

}  // namespace cps::gltf
