#include "files/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "files/files.h"

namespace cps {
namespace {

/// Reads rows from the top of a text.
struct CsvReader {
  std::string_view text;
  const std::filesystem::path& file;
  std::size_t at = 0, line = 1;

  std::vector<std::string> next_row() {
    std::vector<std::string> fields(1);
    const std::size_t first_line = line;
    bool is_quoted = false;
    while (at < text.size()) {
      const char c = text[at++];
      const bool is_doubled = at < text.size() && text[at] == c;
      const bool ends_line = c == '\n' || (c == '\r' && at < text.size() && text[at] == '\n');
      if (c == '\n') ++line;
      if (c == '"' && is_quoted && is_doubled)
        fields.back() += text[at++];
      else if (c == '"')
        is_quoted = !is_quoted;
      else if (c == ',' && !is_quoted)
        fields.emplace_back();
      else if (c == '\n' && !is_quoted)
        return fields;
      else if (is_quoted || !ends_line)
        fields.back() += c;
    }
    if (is_quoted)
      throw std::runtime_error(fmt::format("{}: line {}: a quote is not closed", file.string(), first_line));
    return fields;
  }
};

template <typename T>
bool parse_whole(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

const std::string& CsvCell::text() const {
  return table.rows[row][column];
}

double CsvCell::number() const {
  double value = 0;
  if (!parse_whole(text(), value) || !std::isfinite(value)) fail("'" + text() + "' is not a number");
  return value;
}

std::int64_t CsvCell::whole_number() const {
  std::int64_t value = 0;
  if (!parse_whole(text(), value)) fail("'" + text() + "' is not a whole number");
  return value;
}

void CsvCell::fail(const std::string& what) const {
  throw std::runtime_error(
      fmt::format("{}: line {}: {}: {}", table.file.string(), table.lines[row], table.header[column], what));
}

std::size_t CsvTable::column(const char* name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) throw std::runtime_error(file.string() + ": " + name + ": column is missing");
  return static_cast<std::size_t>(found - header.begin());
}

CsvTable parse_csv(std::string_view text, const std::filesystem::path& file) {
  CsvReader reader{text, file};
  CsvTable table{.file = file, .header = reader.next_row()};
  while (reader.at < text.size()) {
    table.lines.push_back(reader.line);
    table.rows.push_back(reader.next_row());
    if (table.rows.back().size() != table.header.size())
      throw std::runtime_error(fmt::format("{}: line {}: has {} fields, its header {}", file.string(),
                                           table.lines.back(), table.rows.back().size(),
                                           table.header.size()));
  }
  return table;
}

CsvTable read_csv(const std::filesystem::path& file) {
  return parse_csv(read_file(file), file);
}

}  // namespace cps
