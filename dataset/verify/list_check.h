#pragma once

#include "dataset/verify/dataset_files.h"

namespace cps {

/// Checks split lists, frames.csv and the image files against each other: every image once in each, in the
/// part that its lens belongs to, and as many as dataset.json says.
void check_lists(const DatasetFiles& files, Faults& faults);

/// Checks that no street of a scene occurs in two parts, unless the recipe's split is `thesis`.
void check_streets(const DatasetFiles& files, Faults& faults);

}  // namespace cps
