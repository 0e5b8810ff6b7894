#include "dataset/migrate/migrate.h"

#include "dataset/job/frames.h"
#include "dataset/job/journal.h"
#include "dataset/verify/dataset_files.h"
#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The functions return whether the file had to be rewritten.
bool migrate_label(const fs::path& file, const Label& label) {
  const Json old = Json::parse(read_file(file));
  if (old.at("schema") == label_schema) return false;
  Json json;
  for (const auto& [key, value] : old.items()) {
    json[key] = value;
    if (key == "camera") json["gravity"] = nullptr;  // its place
  }
  json["schema"] = label_schema;
  json["gravity"] = to_json(label).at("gravity");
  write_json(file, json);
  return true;
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += csv_field(field) + ',';
  line.back() = '\n';
  return line;
}

/// Adds the columns that can be derived, each after the one that stands before it in frame_columns(). Fields
/// that are there keep their text, which rows would write differently in the last bit.
bool migrate_frames(const fs::path& file) {
  CsvTable table = read_csv(file);
  const std::size_t columns = table.header.size();
  const std::vector<FrameRow> rows = read_frames_csv(file);
  std::ptrdiff_t next = 0;
  for (const FrameColumn& column : frame_columns()) {
    if (const std::optional<std::size_t> place = find_column(table, column)) {
      next = static_cast<std::ptrdiff_t>(*place) + 1;
      continue;
    }
    table.header.insert(table.header.begin() + next, column.name);
    for (std::size_t r = 0; r < rows.size(); ++r)
      table.rows[r].insert(table.rows[r].begin() + next, column.write(rows[r]));
    ++next;
  }
  if (table.header.size() == columns) return false;
  std::string text = csv_line(table.header);
  for (const std::vector<std::string>& row : table.rows) text += csv_line(row);
  write_file(file, text);
  return true;
}

bool migrate_description(const fs::path& file) {
  Json json = Json::parse(read_file(file));
  if (json.at("schema") == label_schema) return false;
  json["schema"] = label_schema;
  write_json(file, json);
  return true;
}

}  // namespace

std::int64_t migrate_dataset(const fs::path& root, const MigrationProgress& progress) {
  const DatasetFiles files = open_dataset(root);
  const fs::path description = root / "dataset.json";
  if (files.description) schema_of({*files.description, description.string()});
  const FileLock folder(folder_lock(root), FileLock::Kind::exclusive);
  if (!folder.is_held())
    throw HeldByAnother(root.string() +
                        ": other processes still work there; run it again when they are done");
  std::int64_t rewritten = 0;
  for (const DatasetGroup& group : files.dataset.groups) {
    const fs::path leaf = root / group.folder;
    remove_temporaries(leaf);
    rewritten += migrate_label(leaf / "calibration.json", group.label);
    if (files.description) rewritten += migrate_frames(leaf / "frames.csv");
    progress(group.folder.string());
  }
  if (files.description) rewritten += migrate_description(description);
  return rewritten;
}

}  // namespace cps
