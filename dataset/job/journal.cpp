#include "dataset/job/journal.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <sstream>
#include <stdexcept>

#include "dataset/dense/dense_file.h"
#include "dataset/job/shard_files.h"
#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

const char* const journal_kind = "journal";

/// The length of `text` up to and including its last line break.
std::size_t length_of_lines(const std::string& text) {
  return text.rfind('\n') + 1;  // npos + 1 = 0: no whole line
}

/// Eight hexadecimal digits that show whether a line is damaged.
std::string check_digits(const nlohmann::ordered_json& line) {
  return sha256(line.dump()).substr(0, 8);
}

std::string line_of(const ViewRecord& record) {
  nlohmann::ordered_json line = to_json(record);
  line["check"] = check_digits(line);
  return line.dump() + "\n";
}

/// Throws std::runtime_error when the line is damaged.
ViewRecord record_of(const std::string& text, const fs::path& file) {
  nlohmann::ordered_json line = nlohmann::ordered_json::parse(text);
  const std::string check = line.value("check", "");
  line.erase("check");
  if (check != check_digits(line)) throw std::runtime_error(file.string() + ": a line is damaged");
  return view_record_from_json(line, file.string());
}

/// Calls visit(record) for each whole line. Returns the number of damaged ones.
template <typename Visit>
int read_journal(const fs::path& file, Visit&& visit) {
  int unreadable = 0;
  const std::string text = read_file(file);
  std::istringstream whole_lines(text.substr(0, length_of_lines(text)));
  for (std::string line; std::getline(whole_lines, line);) try {
      visit(record_of(line, file));
    } catch (const std::exception&) {
      ++unreadable;
    }
  return unreadable;
}

}  // namespace

JournalLines read_journals(const fs::path& dataset) {
  JournalLines lines;
  for (const auto& [shard, file] : shard_files(dataset, journal_kind))
    lines.unreadable +=
        read_journal(file, [&](ViewRecord&& record) { lines.views[record.view] = std::move(record); });
  return lines;
}

std::vector<JournalTally> tally_journals(const fs::path& dataset) {
  std::vector<JournalTally> tallies;
  for (const auto& [shard, file] : shard_files(dataset, journal_kind)) {
    JournalTally tally{.shard = shard};
    tally.unreadable = read_journal(file, [&](const ViewRecord& record) {
      ++tally.views;
      tally.images += static_cast<std::int64_t>(record.images.size());
      for (const ImageRecord& image : record.images) tally.bytes += image.bytes;
    });
    tallies.push_back(tally);
  }
  return tallies;
}

std::vector<std::int64_t> journalled_shard_counts(const fs::path& dataset) {
  std::set<std::int64_t> counts;
  for (const auto& [shard, file] : shard_files(dataset, journal_kind)) counts.insert(shard.count);
  return {counts.begin(), counts.end()};
}

fs::path folder_lock(const fs::path& dataset) {
  return dataset / ".cps" / "lock";
}

bool has_its_images(const fs::path& dataset, const ViewRecord& record) {
  const auto is_there = [&](const fs::path& file, std::uint64_t bytes) {
    std::error_code missing;
    const std::uintmax_t found = fs::file_size(dataset / file, missing);
    return !missing && found == bytes;
  };
  const auto has_labels = [&](const ImageRecord& image) {
    return std::ranges::all_of(image.dense, [&](const DenseRecord& dense) {
      return is_there(dense_file(image.file, dense.label), dense.bytes);
    });
  };
  return std::ranges::all_of(record.images,
                             [&](const ImageRecord& image) {
                               return is_there(image.file, image.bytes) && has_labels(image);
                             }) &&
         (!record.master || is_there(record.master->file, record.master->bytes));
}

Journal::Journal(const fs::path& dataset, const Shard& shard)
    : file_(shard_file(dataset, journal_kind, shard)), lock_(file_, FileLock::Kind::exclusive) {
  if (!lock_.is_held())
    throw HeldByAnother(dataset.string() + ": shard " + to_string(shard) +
                        " is being made by another process; wait for it or choose another shard");
  const std::string text = read_file(file_);
  if (ftruncate(lock_.descriptor(), static_cast<off_t>(length_of_lines(text))) != 0)
    throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
}

void Journal::append(const ViewRecord& record) {
  const std::string line = line_of(record);
  const off_t before = lseek(lock_.descriptor(), 0, SEEK_END);
  // A single write: a kill leaves either the whole line or a last line without its line break.
  errno = 0;
  const ssize_t written = write(lock_.descriptor(), line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size()) && fdatasync(lock_.descriptor()) == 0) return;
  const std::string cause = errno ? std::strerror(errno) : "the disk is full";
  if (before < 0 || ftruncate(lock_.descriptor(), before) != 0) {
    // The next process to open the journal removes the cut line.
  }
  throw std::runtime_error(file_.string() + ": cannot be written: " + cause);
}

}  // namespace cps
