#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Tables of text as RFC 4180 has them, without line breaks inside fields.
namespace cps {

/// A field as it stands in a line: quoted only when it must be.
std::string csv_field(const std::string& text);

/// A table with a header.
struct CsvTable {
  std::filesystem::path file;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header

  /// Throws std::runtime_error with one line when there is none of that name.
  std::size_t column(const char* name) const;
  /// Throws std::runtime_error with one line when the field is not a number.
  double number(std::size_t row, std::size_t column) const;
};

/// Throws std::runtime_error with one line when the file cannot be read or a line has more or fewer fields
/// than the header.
CsvTable read_csv(const std::filesystem::path& file);

}  // namespace cps
