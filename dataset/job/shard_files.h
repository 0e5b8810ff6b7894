#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sampler/plan/shard.h"

namespace cps {

/// The file of a kind that a shard keeps: `<dataset>/.cps/KIND_3_of_8.jsonl`.
std::filesystem::path shard_file(const std::filesystem::path& dataset, const std::string& kind,
                                 const Shard& shard);

/// The files of a kind that are there, sorted by name.
std::vector<std::pair<Shard, std::filesystem::path>> shard_files(const std::filesystem::path& dataset,
                                                                 const std::string& kind);

}  // namespace cps
