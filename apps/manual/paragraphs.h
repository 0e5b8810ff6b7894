#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cps {

/// Plain text, cut at its empty lines.
struct Paragraph {
  std::string text;          ///< one line; of a verbatim paragraph, its lines
  bool is_verbatim = false;  ///< its lines begin with spaces and keep their breaks
};

std::vector<Paragraph> paragraphs(std::string_view text);

/// Number of characters of a text in UTF-8.
std::size_t length(std::string_view text);

/// Breaks a line between words, so that no line is longer than `width` characters unless one word is. Lines
/// after the first begin with `indent` spaces, and the first is taken to begin at column `column`. No line
/// break at the end.
std::string filled(std::string_view line, std::size_t width, std::size_t indent, std::size_t column);

}  // namespace cps
