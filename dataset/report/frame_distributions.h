#pragma once

#include <optional>
#include <vector>

#include "dataset/job/frames.h"
#include "dataset/labels/label.h"
#include "dataset/report/distribution.h"
#include "sampler/recipe/recipe.h"

namespace cps {

/// Empty distributions of the numbers in frames.csv, with the recipe's limits: poses, exposure, sensor.
std::vector<Distribution> frame_distributions(const Recipe& recipe);

/// Adds one line of frames.csv to what frame_distributions() returned. `label`: of its group.
void add_frame(std::vector<Distribution>& distributions, const FrameRow& row, const Label& label);

}  // namespace cps
