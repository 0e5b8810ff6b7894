#include "dataset/job/job.h"

#include <sstream>
#include <stdexcept>

#include "files/file_lock.h"
#include "files/files.h"
#include "files/json_keys.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

fs::path job_file(const fs::path& dataset) {
  return dataset / ".cps" / "job.json";
}

/// `"key = old" became "key = new"` for the first line that differs; empty when none does.
std::string first_difference(const std::string& before, const std::string& now) {
  std::istringstream before_lines(before), now_lines(now);
  while (before_lines || now_lines) {
    std::string a, b;
    std::getline(before_lines, a);
    std::getline(now_lines, b);
    if (a != b) return "\"" + a + "\" became \"" + b + "\"";
  }
  return "";
}

/// Whether a line of Job::scenes has a hash.
bool is_known(const std::string& scene_line) {
  return !scene_line.empty() && !scene_line.ends_with("= ");
}

/// Job::scenes with every hash that one of two jobs of the same recipe knows; the first one's where both do.
std::string joined_scenes(const std::string& first, const std::string& second) {
  std::istringstream first_lines(first), second_lines(second);
  for (std::string joined;;) {
    std::string a, b;
    std::getline(first_lines, a);
    std::getline(second_lines, b);
    if (!first_lines && !second_lines) return joined;
    joined += (is_known(a) || b.empty() ? a : b) + "\n";
  }
}

std::string first_difference(const Job& before, const Job& now) {
  for (const auto member : {&Job::recipe, &Job::rig, &Job::drive, &Job::generator}) {
    const std::string difference = first_difference(before.*member, now.*member);
    if (!difference.empty()) return difference;
  }
  // Where both orders of joining agree, no scene has two hashes.
  return first_difference(joined_scenes(before.scenes, now.scenes), joined_scenes(now.scenes, before.scenes));
}

}  // namespace

bool has_job(const fs::path& dataset) {
  return fs::exists(job_file(dataset));
}

Job read_job(const fs::path& dataset) {
  if (!has_job(dataset))
    throw std::runtime_error(dataset.string() +
                             ": has no .cps/job.json: no cps generate was begun in this folder");
  const std::string file = job_file(dataset).string();
  const nlohmann::json json = read_json(file);
  const JsonKeys keys{json, file};
  return {.recipe = keys.text("recipe"),
          .rig = keys.text("rig"),
          .drive = keys.text("drive"),
          .scenes = keys.text("scenes"),
          .generator = keys.text("generator"),
          .folder = keys.text("folder")};
}

void require_same_job(const fs::path& dataset, const Job& job) {
  if (!has_job(dataset)) return;
  const std::string difference = first_difference(read_job(dataset), job);
  if (!difference.empty())
    throw std::runtime_error(dataset.string() + ": was begun by another job (" + difference +
                             "); use the same recipe or another folder");
}

void begin_job(const fs::path& dataset, const Job& job) {
  const FileLock one_at_a_time(dataset / ".cps" / "job.lock", FileLock::Kind::exclusive, true);
  require_same_job(dataset, job);
  const Job begun = has_job(dataset) ? read_job(dataset) : job;
  const std::string scenes = joined_scenes(begun.scenes, job.scenes);
  if (has_job(dataset) && scenes == begun.scenes) return;
  write_json(job_file(dataset), {{"recipe", begun.recipe},
                                 {"rig", begun.rig},
                                 {"drive", begun.drive},
                                 {"scenes", scenes},
                                 {"generator", begun.generator},
                                 {"folder", begun.folder.string()}});
}

}  // namespace cps
