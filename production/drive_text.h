#pragma once

#include <string>

#include "sampler/recipe/recipe.h"
#include "scenes/drive/driven_scene.h"

namespace cps {

/// Empty if the recipe's scenes can be driven like this; otherwise one line that names the field and the fix.
std::string fault_of(const DriveOptions& drive, const Recipe& recipe);

/// The options as a job keeps them, a key a line, with the SHA-256 of the route's file: what decides the
/// dataset's bytes. Throws std::runtime_error when the route cannot be read.
std::string to_text(const DriveOptions& drive);

/// The other way; the hash is not checked. Throws boost::program_options::error in one line when a key is
/// unknown or a number cannot be read.
DriveOptions drive_from_text(const std::string& text);

}  // namespace cps
