#pragma once

#include "sampler/recipe/recipe.h"

namespace cps {

/// Draws a lens for each size and H-FOV of an otherwise valid recipe, to refuse limits that leave no lens
/// before any work is done. Throws std::runtime_error in one line: set, keys, reason.
void require_lenses(const Recipe& recipe);

}  // namespace cps
