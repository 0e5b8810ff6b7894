#include "dataset/job/ledger.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "dataset/job/shard_files.h"
#include "files/files.h"
#include "files/json_keys.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

const char* const times_kind = "times";

nlohmann::ordered_json to_json(const RunTimes& times) {
  return {{"views", times.views},
          {"images", times.images},
          {"interrupted", times.is_interrupted},
          {"threads", times.threads},
          {"wall_s", times.wall_s},
          {"cpu_s", times.cpu_s},
          {"render_s", times.cpu.render_s},
          {"labels_s", times.cpu.labels_s},
          {"warp_s", times.cpu.warp_s},
          {"develop_s", times.cpu.develop_s},
          {"encode_s", times.cpu.encode_s},
          {"write_s", times.cpu.write_s}};
}

RunTimes run_times(const std::string& line, const std::string& file) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(line);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file + ": is not JSON: " + error.what());
  }
  const JsonKeys keys{json, file};
  return {.views = static_cast<std::int64_t>(keys.unsigned_integer("views")),
          .images = static_cast<std::int64_t>(keys.unsigned_integer("images")),
          .is_interrupted = keys.at("interrupted") == true,
          .threads = static_cast<int>(keys.unsigned_integer("threads")),
          .wall_s = keys.number("wall_s"),
          .cpu_s = keys.number("cpu_s"),
          .cpu = {.render_s = keys.number("render_s"),
                  .labels_s = json.contains("labels_s") ? keys.number("labels_s") : 0,
                  .warp_s = keys.number("warp_s"),
                  .develop_s = keys.number("develop_s"),
                  .encode_s = keys.number("encode_s"),
                  .write_s = keys.number("write_s")}};
}

}  // namespace

void enter_in_ledger(const fs::path& dataset, const Shard& shard, const RunTimes& times) {
  const fs::path file = shard_file(dataset, times_kind, shard);
  write_file(file, (fs::exists(file) ? read_file(file) : "") + to_json(times).dump() + "\n");
}

std::vector<LedgerEntry> read_ledger(const fs::path& dataset) {
  std::vector<LedgerEntry> entries;
  for (const auto& [shard, file] : shard_files(dataset, times_kind)) {
    std::istringstream lines(read_file(file));
    for (std::string line; std::getline(lines, line);)
      entries.push_back({shard, run_times(line, file.string())});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const LedgerEntry& a, const LedgerEntry& b) {
    return std::tie(a.shard.count, a.shard.index) < std::tie(b.shard.count, b.shard.index);
  });
  return entries;
}

}  // namespace cps
