#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "dataset/job/records.h"
#include "files/file_lock.h"
#include "sampler/plan/shard.h"

/// Append-only records of finished views, one JSON line each, in `<dataset>/.cps/`: a file per shard, so that
/// no two processes write to one. What counts as made is what stands in any of them.
namespace cps {

struct JournalLines {
  std::map<std::int64_t, ViewRecord> views;  ///< by index
  int unreadable = 0;                        ///< lines that are damaged: their views will be made again
};

/// Every journal of a folder. A last line without its end, which a kill leaves or another process is just
/// writing, counts as not there.
JournalLines read_journals(const std::filesystem::path& dataset);

/// The numbers of shards that a folder has journals of, each once, ascending.
std::vector<std::int64_t> journalled_shard_counts(const std::filesystem::path& dataset);

/// Held shared by who makes images in a folder, and alone by who finishes it.
std::filesystem::path folder_lock(const std::filesystem::path& dataset);

/// Whether all images of a view are there, and its master if it was kept, each as long as when it was
/// written. Their bytes are not read: a crash may cut a file short, and verify finds what else can happen to
/// one.
bool has_its_images(const std::filesystem::path& dataset, const ViewRecord& record);

/// One shard's journal, held by one process.
class Journal {
 public:
  /// Opens or starts the journal; a last line cut short by a kill is removed. Throws std::runtime_error when
  /// another process holds it or it cannot be written.
  Journal(const std::filesystem::path& dataset, const Shard& shard);

  /// Adds a view; on disk when it returns. Throws std::runtime_error when it cannot be written, and leaves
  /// no part of a line.
  void append(const ViewRecord& record);

 private:
  std::filesystem::path file_;
  FileLock lock_;
};

}  // namespace cps
