#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Tables of text as RFC 4180 defines them: a field in quotes may hold commas, quotes and line breaks.
/// Written by hand because the format is thirty lines of code, and errors must name file, line and column.
namespace cps {

/// A field as it is written into a line: in quotes only when it must be.
std::string csv_field(const std::string& text);

struct CsvTable;

/// One field of a table, and where it stands. The functions throw std::runtime_error with one line,
/// `<file>: line <n>: <column>: <what is wrong>`.
struct CsvCell {
  const CsvTable& table;
  std::size_t row, column;

  const std::string& text() const;
  /// A finite number.
  double number() const;
  std::int64_t whole_number() const;
  [[noreturn]] void fail(const std::string& what) const;
};

/// A table with a header.
struct CsvTable {
  std::filesystem::path file;
  std::vector<std::string> header = {};
  std::vector<std::vector<std::string>> rows = {};  ///< each as long as the header
  std::vector<std::size_t> lines = {};              ///< line of the file where each row begins, from 1

  /// Index of the column of that name. Throws std::runtime_error with one line when there is none.
  std::size_t column(const char* name) const;
  CsvCell at(std::size_t row, std::size_t column) const { return {*this, row, column}; }
};

/// The table that `text` holds; `file` is for error messages. Throws std::runtime_error with one line, file
/// and line first, when a row has more or fewer fields than the header, or a quote is not closed.
CsvTable parse_csv(std::string_view text, const std::filesystem::path& file);

/// The same of a file. Also throws when it cannot be read.
CsvTable read_csv(const std::filesystem::path& file);

}  // namespace cps
