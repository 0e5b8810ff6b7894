#pragma once

#include "sampler/recipe/recipe.h"

namespace cps {

/// Draws a lens for each size and H-FOV of a recipe that is valid otherwise, so that limits that leave none
/// are found before any work. Throws std::runtime_error in one line: set, keys, reason.
void require_lenses(const Recipe& recipe);

}  // namespace cps
