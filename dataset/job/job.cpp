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

std::string first_difference(const Job& before, const Job& now) {
  for (const auto member : {&Job::recipe, &Job::rig, &Job::drive, &Job::generator}) {
    const std::string difference = first_difference(before.*member, now.*member);
    if (!difference.empty()) return difference;
  }
  if (before.scenes.empty() || now.scenes.empty()) return "";
  return first_difference(before.scenes, now.scenes);
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
  if (has_job(dataset)) return;
  write_json(job_file(dataset), {{"recipe", job.recipe},
                                 {"rig", job.rig},
                                 {"drive", job.drive},
                                 {"scenes", job.scenes},
                                 {"generator", job.generator},
                                 {"folder", job.folder.string()}});
}

}  // namespace cps
