#pragma once

#include "sampler/recipe/recipe.h"

namespace cps {

/// A valid recipe, smaller (or larger): views of each set and drawn cities times `scale`, of named scenes and
/// cities the first so many; at least 3 views and one scene are left. Conditions per scene, lenses per view
/// and views per lens stay, and so do the views that a condition has. Throws std::runtime_error when `scale`
/// is out of its range or the recipe is not valid afterwards.
Recipe scaled_recipe(Recipe recipe, double scale);

}  // namespace cps
