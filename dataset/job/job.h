#pragma once

#include <filesystem>
#include <string>

namespace cps {

/// A generation job as recorded in its folder (`.cps/job.json`): everything that decides the dataset's bytes,
/// as text with one key per line.
struct Job {
  std::string recipe, rig, drive;
  /// A line `sha256 of NAME = HASH` per scene. HASH is empty for scenes that no process has used yet; all is
  /// empty while nothing is known.
  std::string scenes = {};
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
/// A scene is compared only if both jobs know its hash.
void require_same_job(const std::filesystem::path& dataset, const Job& job);

/// Writes the job's file if there is none; otherwise compares, and adds the scenes that the file does not
/// know. When several processes begin at once, they do so one after the other. Throws as require_same_job()
/// does, or when the file cannot be written.
void begin_job(const std::filesystem::path& dataset, const Job& job);

}  // namespace cps
