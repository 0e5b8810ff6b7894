#pragma once

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "files/files.h"
#include "tests/dataset/edit_csv.h"

namespace cps {

/// Turns a calibration.json or dataset.json into one of schema 1.
inline void make_old_json(const std::filesystem::path& file) {
  auto json = nlohmann::ordered_json::parse(read_file(file));
  json["schema"] = 1;
  json.erase("gravity");
  write_json(file, json);
}

/// Turns a frames.csv into one of schema 1.
inline void make_old_table(const std::filesystem::path& file) {
  CsvTable table = read_csv(file);
  for (const char* name : {"gravity_x", "gravity_y", "gravity_z"}) {
    const auto column = std::find(table.header.begin(), table.header.end(), name) - table.header.begin();
    if (column == std::ssize(table.header)) continue;
    table.header.erase(table.header.begin() + column);
    for (std::vector<std::string>& row : table.rows) row.erase(row.begin() + column);
  }
  write_csv(table);
}

/// Turns a dataset into one of schema 1.
inline void make_old(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) files.push_back(entry.path());
  for (const std::filesystem::path& file : files) {
    const std::filesystem::path name = file.filename();
    if (name == "calibration.json" || name == "dataset.json") make_old_json(file);
    if (name == "frames.csv") make_old_table(file);
  }
}

}  // namespace cps
