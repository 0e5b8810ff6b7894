#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "dataset/job/records.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Writes the files that describe the whole dataset: labels of groups without views, frames.csv in every leaf
/// folder, the split lists, and last dataset.json, which marks the dataset as finished. Removes temporary
/// files of killed processes, so no other process may be writing there. `records` must hold every view of the
/// plan; `scene_sha256` is parallel to its scenes.
void finish_dataset(const std::filesystem::path& root, const Plan& plan,
                    const std::map<std::int64_t, ViewRecord>& records,
                    const std::vector<std::string>& scene_sha256);

/// Whether the folder has a dataset.json.
bool is_finished(const std::filesystem::path& root);

}  // namespace cps
