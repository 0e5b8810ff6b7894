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

/// `key = old` → `key = new` of the first line that differs.
std::string first_difference(const std::string& before, const std::string& now) {
  std::istringstream before_lines(before), now_lines(now);
  for (std::string a, b; std::getline(before_lines, a) && std::getline(now_lines, b);)
    if (a != b) return "\"" + a + "\" became \"" + b + "\"";
  return "the scenes' files or the program's version changed";
}

}  // namespace

Journal::Journal(const fs::path& dataset, const std::string& fingerprint, const std::string& recipe_text)
    : file_(dataset / ".cps" / "journal.jsonl") {
  const fs::path job = dataset / ".cps" / "job.json";
  if (fs::exists(job)) {
    const nlohmann::json known = read_json(job);
    if (known.value("fingerprint", "") != fingerprint)
      throw std::runtime_error(dataset.string() + ": was begun by another job (" +
                               first_difference(known.value("recipe", ""), recipe_text) +
                               "); use the same recipe or another folder");
    if (fs::exists(file_)) read_lines(dataset);
  } else {
    write_json(job, {{"fingerprint", fingerprint}, {"recipe", recipe_text}});
  }
  descriptor_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw std::runtime_error(file_.string() + ": cannot be opened: " + std::strerror(errno));
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
    const bool is_complete = std::all_of(record.images.begin(), record.images.end(), [&](const ImageRecord& image) {
      return fs::exists(dataset / image.file);
    });
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
