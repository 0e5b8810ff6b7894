#pragma once

#include "sampler/recipe/recipe.h"

namespace cps {

/// Makes a valid recipe smaller or larger: multiplies the views of each set and the number of drawn cities by
/// `scale`, and keeps that share of the named scenes and cities; at least 3 views and one scene are left.
/// Conditions per scene, lenses per view, views per lens and views per condition stay. Throws
/// std::runtime_error if `scale` is out of range or the scaled recipe is not valid.
Recipe scaled_recipe(Recipe recipe, double scale);

}  // namespace cps
