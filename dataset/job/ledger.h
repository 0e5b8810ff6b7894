#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sampler/plan/shard.h"

/// What time the runs of cps generate took, in `<dataset>/.cps/`: a file per shard, a JSON line per run. It
/// tells what a dataset cost. Nothing depends on it.
namespace cps {

/// CPU seconds of each stage, all threads together.
struct StageTimes {
  double render_s = 0;
  double labels_s = 0;  ///< dense labels: their rays, encoding and writing
  double warp_s = 0, develop_s = 0, encode_s = 0, write_s = 0;
  double sum_s() const { return render_s + labels_s + warp_s + develop_s + encode_s + write_s; }
};

/// One run: what it made and the time it took.
struct RunTimes {
  std::int64_t views = 0, images = 0;
  bool is_interrupted = false;  ///< stopped by its watch before all views were made
  int threads = 1;
  double wall_s = 0, cpu_s = 0;  ///< of everything, loading scenes as well
  StageTimes cpu;
};

struct LedgerEntry {
  Shard shard;
  RunTimes times;
};

/// Adds a run to the shard's file. Only the process that holds the shard's journal may call it. Throws
/// std::runtime_error naming the file when it cannot be read or written.
void enter_in_ledger(const std::filesystem::path& dataset, const Shard& shard, const RunTimes& times);

/// All runs, by shard and in their order; none where no ledger was kept. Throws std::runtime_error with one
/// line: file, key, what is wrong.
std::vector<LedgerEntry> read_ledger(const std::filesystem::path& dataset);

}  // namespace cps
