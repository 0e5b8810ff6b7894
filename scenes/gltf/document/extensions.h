#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// Refuses a file that requires an extension the importer does not support, by the extension's name.
void check_required_extensions(const std::filesystem::path& file, const nlohmann::json& root);

/// Warns of each used extension that the importer ignores.
void warn_of_ignored_extensions(Document& document);

}  // namespace cps::gltf
