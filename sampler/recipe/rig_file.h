#pragma once

#include <filesystem>
#include <string>

#include "scenes/rig.h"

namespace cps {

/// Reads a rig file: a section per camera, `[name]`, and in it `key = value` lines for its pose in vehicle
/// axes (docs/formats.md). Throws std::runtime_error in one line: file, camera and key, fix.
Rig read_rig(const std::filesystem::path& file);

/// The rig that a recipe's `rig` key names: the file at that path, else the one in the recipe's folder; the
/// default rig (one camera, front) if `named` is empty. Throws as read_rig() does.
Rig find_rig(const std::string& named, const std::filesystem::path& recipe_folder);

/// The rig of a file's text. Throws std::runtime_error in one line: camera and key, fix.
Rig rig_from_text(const std::string& text);

/// The rig as a file that reads back to the same rig.
std::string to_text(const Rig& rig);

}  // namespace cps
