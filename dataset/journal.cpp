#include "dataset/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "dataset/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

fs::path job_file(const fs::path& dataset) {
  return dataset / ".cps" / "job.json";
}

/// `key = old` → `key = new` of the first line that differs.
std::string first_difference(const std::string& before, const std::string& now) {
  std::istringstream before_lines(before), now_lines(now);
  for (std::string a, b; std::getline(before_lines, a) && std::getline(now_lines, b);)
    if (a != b) return "\"" + a + "\" became \"" + b + "\"";
  return "the scenes' files or the program's version changed";
}

}  // namespace

void require_same_job(const fs::path& dataset, const Job& job) {
  if (!fs::exists(job_file(dataset))) return;
  const nlohmann::json known = read_json(job_file(dataset));
  if (known.value("fingerprint", "") != job.fingerprint)
    throw std::runtime_error(dataset.string() + ": was begun by another job (" +
                             first_difference(known.value("recipe", ""), job.recipe_text) +
                             "); use the same recipe or another folder");
}

Journal::Journal(const fs::path& dataset, const Job& job) : file_(dataset / ".cps" / "journal.jsonl") {
  require_same_job(dataset, job);
  if (!fs::exists(job_file(dataset)))
    write_json(job_file(dataset), {{"fingerprint", job.fingerprint}, {"recipe", job.recipe_text}});
  if (fs::exists(file_)) read_lines(dataset);
  descriptor_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw std::runtime_error(file_.string() + ": cannot be opened: " + std::strerror(errno));
}

Journal::~Journal() {
  if (descriptor_ >= 0) close(descriptor_);
}

void Journal::read_lines(const fs::path& dataset) {
  const std::string text = read_file(file_);
  const std::size_t complete = text.rfind('\n') + 1;  // npos + 1 = 0: no complete line
  if (complete < text.size()) {
    fs::resize_file(file_, complete);
    ++dropped_lines_;
  }
  std::istringstream lines(text.substr(0, complete));
  for (std::string line; std::getline(lines, line);) {
    ViewRecord record;
    try {
      record = view_record_from_json(nlohmann::json::parse(line), file_.string());
    } catch (const std::exception&) {
      ++dropped_lines_;
      continue;
    }
    const bool is_complete =
        std::all_of(record.images.begin(), record.images.end(),
                    [&](const ImageRecord& image) { return fs::exists(dataset / image.file); });
    if (is_complete) finished_[record.view] = std::move(record);
  }
}

void Journal::append(const ViewRecord& record) {
  const std::string line = to_json(record).dump() + "\n";
  // One write, so that a kill leaves either the whole line or a last line without its newline.
  const ssize_t written = write(descriptor_, line.data(), line.size());
  if (written != static_cast<ssize_t>(line.size()))
    throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
  finished_[record.view] = record;
}

}  // namespace cps
