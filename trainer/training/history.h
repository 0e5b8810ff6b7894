#pragma once

#include <filesystem>
#include <vector>

#include "trainer/training/train.h"

namespace cps {

/// history.csv, one line an epoch, and history.svg, the curves of it, in the model's folder.
void save_history(const std::vector<EpochReport>& epochs, const std::filesystem::path& model_folder);

}  // namespace cps
