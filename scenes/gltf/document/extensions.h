#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// Refuses a file that cannot be read rightly without an extension that is not read here, by the extension's
/// name.
void check_required_extensions(const std::filesystem::path& file, const nlohmann::json& root);

/// Warns of each extension that the file uses and that is left out.
void warn_of_unread_extensions(Document& document);

}  // namespace cps::gltf
