#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "dataset/job/records.h"
#include "files/file_lock.h"
#include "sampler/plan/shard.h"

/// Append-only records of finished views, one JSON line each, in `<dataset>/.cps/`: a file per shard, so that
/// no two processes write to the same file. A view counts as made if any journal holds it.
namespace cps {

struct JournalLines {
  std::map<std::int64_t, ViewRecord> views;  ///< by index
  int unreadable = 0;                        ///< damaged lines: their views will be made again
};

/// Reads every journal of a folder. A last line without its line break is ignored: a process was killed while
/// writing it, or is still writing.
JournalLines read_journals(const std::filesystem::path& dataset);

/// The numbers of shards n (of `--shard i/n`) that a folder has journals of, each once, ascending.
std::vector<std::int64_t> journalled_shard_counts(const std::filesystem::path& dataset);

/// What one journal holds.
struct JournalTally {
  Shard shard;
  std::int64_t views = 0, images = 0;
  std::uint64_t bytes = 0;  ///< of the images' files
  int unreadable = 0;       ///< damaged lines
};

/// Adds up every journal of a folder, line by line. A view that two shards made counts in both.
std::vector<JournalTally> tally_journals(const std::filesystem::path& dataset);

/// The lock file of a folder. Processes that make images there hold it shared, the one that finishes the
/// dataset holds it exclusively.
std::filesystem::path folder_lock(const std::filesystem::path& dataset);

/// Whether all images of a view exist, with their dense labels, and its master if it was kept, each with the
/// length it was written with. Only lengths are compared, as a crash may cut a file short; `cps verify` finds
/// other damage.
bool has_its_images(const std::filesystem::path& dataset, const ViewRecord& record);

/// The journal of one shard, open for writing in one process.
class Journal {
 public:
  /// Opens or creates the journal and removes a last line that was cut short. Throws HeldByAnother when
  /// another process has it open, std::runtime_error when it cannot be written.
  Journal(const std::filesystem::path& dataset, const Shard& shard);

  /// Adds a view and waits until it is on the disk. Throws std::runtime_error when it cannot be written, and
  /// then leaves no part of a line.
  void append(const ViewRecord& record);

 private:
  std::filesystem::path file_;
  FileLock lock_;
};

}  // namespace cps
