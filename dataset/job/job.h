#pragma once

#include <filesystem>
#include <string>

namespace cps {

/// A generation job as its folder knows it (`.cps/job.json`): all that decides the dataset's bytes, as text,
/// a key a line.
struct Job {
  std::string recipe, rig, drive;
  std::string scenes = {};     ///< a line per scene with its SHA-256; empty: not known yet
  std::string generator = {};  ///< program and version
  /// Where relative file names in it were meant. Two jobs that differ in nothing else are the same.
  std::filesystem::path folder = {};
};

/// Whether a job was begun in `dataset`.
bool has_job(const std::filesystem::path& dataset);

/// Throws std::runtime_error in one line when none was begun there or its file is damaged.
Job read_job(const std::filesystem::path& dataset);

/// Throws std::runtime_error when another job was begun in `dataset`, naming the first line that differs.
/// Scenes are compared when both know them.
void require_same_job(const std::filesystem::path& dataset, const Job& job);

/// Writes the job's file if there is none; of several processes that begin at once one writes it and the
/// others compare. Throws as require_same_job() does, or when it cannot be written.
void begin_job(const std::filesystem::path& dataset, const Job& job);

}  // namespace cps
