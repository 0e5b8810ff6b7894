#include "apps/manual/paragraphs.h"

#include <algorithm>
#include <sstream>

namespace cps {

std::vector<Paragraph> paragraphs(std::string_view text) {
  std::vector<Paragraph> found;
  std::istringstream lines{std::string(text)};
  bool is_new = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      is_new = true;
      continue;
    }
    const bool is_verbatim = line.front() == ' ';
    if (is_new)
      found.push_back({line, is_verbatim});
    else
      found.back().text += (found.back().is_verbatim ? "\n" : " ") + line;
    is_new = false;
  }
  return found;
}

std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string filled(std::string_view line, std::size_t width, std::size_t indent, std::size_t column) {
  std::string out;
  std::size_t at = column;
  bool is_first = true;  // word of its line
  std::istringstream words{std::string(line)};
  for (std::string word; words >> word; is_first = false) {
    if (!is_first && at + 1 + length(word) > width) {
      out += "\n" + std::string(indent, ' ');
      at = indent;
      is_first = true;
    }
    out += (is_first ? "" : " ") + word;
    at += (is_first ? 0 : 1) + length(word);
  }
  return out;
}

}  // namespace cps
