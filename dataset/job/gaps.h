#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dataset/job/records.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Whether the journals hold the view with all its images, and the files exist with the lengths they were
/// written with. `records`: of all journals.
bool is_made(const std::filesystem::path& dataset, const Plan& plan, std::int64_t view,
             const std::map<std::int64_t, ViewRecord>& records);

/// The part of a plan that a folder lacks.
struct Gaps {
  std::vector<std::int64_t> views;  ///< not yet made
  /// To be printed: one line for each unfinished shard, for every number of shards that the folder has
  /// journals of, and a last line with the total.
  std::vector<std::string> lines;
};

/// `records`: of all journals.
Gaps find_gaps(const std::filesystem::path& dataset, const Plan& plan,
               const std::map<std::int64_t, ViewRecord>& records);

}  // namespace cps
