#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dataset/records.h"
#include "sampler/plan.h"

namespace cps {

/// What a folder lacks of its plan.
struct Gaps {
  std::vector<std::int64_t> views;  ///< not journalled, or with an image that is missing or of another length
  /// For people: a line in all, and one per shard that is not whole, by the numbers of shards that the
  /// folder has journals of.
  std::vector<std::string> lines;
};

/// `records`: what the journals hold. A file that is there and has its length is taken for whole.
Gaps find_gaps(const std::filesystem::path& dataset, const Plan& plan,
               const std::map<std::int64_t, ViewRecord>& records);

}  // namespace cps
