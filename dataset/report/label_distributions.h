#pragma once

#include <optional>
#include <vector>

#include "dataset/labels/reader.h"
#include "dataset/report/distribution.h"
#include "sampler/recipe/recipe.h"

namespace cps {

/// Distributions of the numbers in calibration.json over the images, beside the recipe's limits and the
/// intervals that labels say they were drawn from. Those of lenses leave out images without a lens.
std::vector<Distribution> label_distributions(const Dataset& dataset, const std::optional<Recipe>& recipe);

/// Whether the label's coefficients are all 0.
bool is_undistorted(const Label& label);

}  // namespace cps
