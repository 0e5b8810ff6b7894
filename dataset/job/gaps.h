#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dataset/job/records.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Whether a view is journalled with all its images, and they are there with their lengths. `records`: what
/// the journals hold.
bool is_made(const std::filesystem::path& dataset, const Plan& plan, std::int64_t view,
             const std::map<std::int64_t, ViewRecord>& records);

/// What a folder lacks of its plan.
struct Gaps {
  std::vector<std::int64_t> views;  ///< that are not made
  /// For people: a line in all, and one per shard that is not whole, by the numbers of shards that the
  /// folder has journals of.
  std::vector<std::string> lines;
};

/// `records`: what the journals hold.
Gaps find_gaps(const std::filesystem::path& dataset, const Plan& plan,
               const std::map<std::int64_t, ViewRecord>& records);

}  // namespace cps
