#pragma once

#include <vector>

#include "dataset/labels/reader.h"

namespace cps {

/// Images of one view, or of one place through several cameras of a rig, the undistorted one first.
using SheetRow = std::vector<const DatasetImage*>;

/// What a contact sheet shows of each set (a size at an H-FOV): up to `rows_per_set` views, evenly spread
/// over the set, and of each up to `columns` images. Sorted by set and view. The rows point into `dataset`.
std::vector<SheetRow> choose_sheet_rows(const Dataset& dataset, int rows_per_set, int columns);

}  // namespace cps
