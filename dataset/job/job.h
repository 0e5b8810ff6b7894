#pragma once

#include <filesystem>
#include <string>

namespace cps {

/// A generation job as recorded in its folder (`.cps/job.json`): everything that decides the dataset's bytes,
/// as text with one key per line.
struct Job {
  std::string recipe, rig, drive;
  std::string scenes = {};     ///< a line per scene with its SHA-256; empty while not known
  std::string generator = {};  ///< program and version
  /// The folder that relative file names refer to. Jobs that differ only in it count as the same.
  std::filesystem::path folder = {};
};

/// Whether a job was begun in `dataset`.
bool has_job(const std::filesystem::path& dataset);

/// The job that was begun in `dataset`. Throws std::runtime_error with one line when there is none or its
/// file is damaged.
Job read_job(const std::filesystem::path& dataset);

/// Throws std::runtime_error when a different job was begun in `dataset`, naming the first line that differs.
/// Scenes are compared only if both jobs know them.
void require_same_job(const std::filesystem::path& dataset, const Job& job);

/// Writes the job's file if there is none. When several processes begin at once, one writes it and the others
/// compare. Throws as require_same_job() does, or when the file cannot be written.
void begin_job(const std::filesystem::path& dataset, const Job& job);

}  // namespace cps
