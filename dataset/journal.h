#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "dataset/records.h"

namespace cps {

/// A generation job as its folder knows it.
struct Job {
  std::string fingerprint;  ///< of recipe, scenes and program version
  std::string recipe_text;
};

/// Throws std::runtime_error when `dataset` holds another job, naming the first recipe line that differs.
void require_same_job(const std::filesystem::path& dataset, const Job& job);

/// The append-only record of finished views, one JSON line each, so that a killed job loses at most the views
/// in flight.
class Journal {
 public:
  /// Opens or starts the journal in `<dataset>/.cps/`. A last line cut short by a kill is dropped; lines that
  /// cannot be read are dropped and counted: their views are made again. Throws as require_same_job does, or
  /// when it cannot be opened.
  Journal(const std::filesystem::path& dataset, const Job& job);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Finished views by index whose files are all still there.
  const std::map<std::int64_t, ViewRecord>& finished() const { return finished_; }

  /// Adds a view; on disk when it returns. Throws std::runtime_error when it cannot be written.
  void append(const ViewRecord& record);

  int dropped_lines() const { return dropped_lines_; }

 private:
  void read_lines(const std::filesystem::path& dataset);

  std::filesystem::path file_;
  int descriptor_ = -1;
  int dropped_lines_ = 0;
  std::map<std::int64_t, ViewRecord> finished_;
};

}  // namespace cps
