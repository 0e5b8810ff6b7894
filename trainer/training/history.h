#pragma once

#include <filesystem>
#include <vector>

#include "trainer/training/epoch_report.h"

namespace cps {

/// Writes history.csv, one line per epoch, and history.svg, its curves, to the model folder.
void save_history(const std::vector<EpochReport>& epochs, const std::filesystem::path& model_folder);

}  // namespace cps
