#include "dataset/job/shard_files.h"

#include <algorithm>
#include <cstdio>

namespace cps {

namespace fs = std::filesystem;

fs::path shard_file(const fs::path& dataset, const std::string& kind, const Shard& shard) {
  return dataset / ".cps" /
         (kind + "_" + std::to_string(shard.index) + "_of_" + std::to_string(shard.count) + ".jsonl");
}

std::vector<std::pair<Shard, fs::path>> shard_files(const fs::path& dataset, const std::string& kind) {
  std::vector<std::pair<Shard, fs::path>> files;
  if (!fs::is_directory(dataset / ".cps")) return files;
  const std::string start = kind + "_";
  for (const fs::directory_entry& entry : fs::directory_iterator(dataset / ".cps")) {
    const std::string name = entry.path().filename().string();
    Shard shard;
    if (name.starts_with(start) &&
        std::sscanf(name.c_str() + start.size(), "%ld_of_%ld", &shard.index, &shard.count) == 2 &&
        entry.path() == shard_file(dataset, kind, shard))
      files.emplace_back(shard, entry.path());
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return files;
}

}  // namespace cps
