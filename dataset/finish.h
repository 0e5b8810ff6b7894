#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "dataset/records.h"
#include "sampler/plan.h"

namespace cps {

/// Writes what only the whole dataset knows: frames.csv in every leaf folder, the split lists, and last
/// dataset.json, whose presence means that the dataset is finished. `records` must hold every view of the
/// plan; `scene_sha256` is parallel to its scenes.
void finish_dataset(const std::filesystem::path& root, const Plan& plan,
                    const std::map<std::int64_t, ViewRecord>& records,
                    const std::vector<std::string>& scene_sha256);

bool is_finished(const std::filesystem::path& root);

}  // namespace cps
