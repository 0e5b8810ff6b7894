#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "dataset/job/records.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Writes the group's calibration.json if it is not there: what is there came by rename from the same job.
void write_label(const std::filesystem::path& root, const Plan& plan, const PlannedGroup& group);

/// Writes what only the whole dataset knows: labels that no view asked for, frames.csv in every leaf folder,
/// the split lists, and last dataset.json, whose presence means that the dataset is finished; removes what
/// killed processes left half-written, so that no other process may be writing there. `records` must hold
/// every view of the plan; `scene_sha256` is parallel to its scenes.
void finish_dataset(const std::filesystem::path& root, const Plan& plan,
                    const std::map<std::int64_t, ViewRecord>& records,
                    const std::vector<std::string>& scene_sha256);

bool is_finished(const std::filesystem::path& root);

}  // namespace cps
