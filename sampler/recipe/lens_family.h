#pragma once

#include <string>

#include "sampler/recipe/recipe.h"

namespace cps {

/// Whether the keys go together with lens_model. Empty if they do; otherwise one line that names the key and
/// the fix: a family that is not known and, with a family other than brown_conrady, every key that says
/// something of brown_conrady lenses, of masters or of the crop.
std::string lens_family_fault(const Recipe& recipe);

}  // namespace cps
