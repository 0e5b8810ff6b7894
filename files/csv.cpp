#include "files/csv.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "files/files.h"

namespace cps {
namespace {

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::size_t CsvTable::column(const char* name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) throw std::runtime_error(file.string() + ": " + name + ": column is missing");
  return static_cast<std::size_t>(found - header.begin());
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows[row][column];
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::runtime_error(file.string() + ": line " + std::to_string(row + 2) + ": " + header[column] +
                             ": '" + text + "' is not a number");
  return value;
}

CsvTable read_csv(const std::filesystem::path& file) {
  CsvTable table{.file = file, .header = {}, .rows = {}};
  std::istringstream lines(read_file(file));
  std::string line;
  std::getline(lines, line);
  table.header = csv_fields(line);
  while (std::getline(lines, line)) {
    table.rows.push_back(csv_fields(line));
    if (table.rows.back().size() != table.header.size())
      throw std::runtime_error(file.string() + ": line " + std::to_string(table.rows.size() + 1) + ": has " +
                               std::to_string(table.rows.back().size()) + " fields, its header " +
                               std::to_string(table.header.size()));
  }
  return table;
}

}  // namespace cps
