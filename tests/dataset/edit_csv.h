#pragma once

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "files/csv.h"
#include "files/files.h"

namespace cps {

/// Writes a table to its file.
inline void write_csv(const CsvTable& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += csv_field(row[i]) + (i + 1 < row.size() ? "," : "\n");
  };
  add(table.header);
  for (const std::vector<std::string>& row : table.rows) add(row);
  write_file(table.file, text);
}

/// Changes the field in `column` of each row of a file.
inline void edit_column(const std::filesystem::path& file, const char* column,
                        const std::function<std::string(const std::string&)>& edit) {
  CsvTable table = read_csv(file);
  const std::size_t c = table.column(column);
  REQUIRE_FALSE(table.rows.empty());
  for (std::vector<std::string>& row : table.rows) row[c] = edit(row[c]);
  write_csv(table);
}

/// Adds to a column of numbers.
inline void add_to_column(const std::filesystem::path& file, const char* column, double more) {
  edit_column(file, column,
              [&](const std::string& text) { return fmt::format("{}", std::stod(text) + more); });
}

}  // namespace cps
