#include "apps/manual/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "apps/manual/paragraphs.h"

namespace cps {
namespace {

/// The code point whose UTF-8 begins at `i`, which moves to the next one.
char32_t next_code_point(const std::string& text, std::size_t& i) {
  const auto first = static_cast<unsigned char>(text[i++]);
  if (first < 0x80) return first;
  char32_t point = first & (first >= 0xF0 ? 0x07 : first >= 0xE0 ? 0x0F : 0x1F);
  while (i < text.size() && (text[i] & 0xC0) == 0x80) point = point << 6 | (text[i++] & 0x3F);
  return point;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// What is typed as it stands: every dash is one that can be copied.
std::string literal(const std::string& text) {
  std::string out;
  for (const char c : troff_text(text)) out += c == '-' && !out.ends_with('\\') ? "\\-" : std::string(1, c);
  return out;
}

std::string bold(const std::string& text) {
  return "\\fB" + literal(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + troff_text(text) + "\\fR";
}

/// A form of a synopsis: literals bold, placeholders (words in capitals) italic, brackets and bars upright.
std::string form_text(const std::string& form) {
  std::string text, word;
  const auto end_word = [&] {
    if (word.empty()) return;
    const bool is_placeholder = std::isupper(static_cast<unsigned char>(word[0])) != 0;
    text += word == "..." ? word : is_placeholder ? italic(word) : bold(word);
    word.clear();
  };
  for (const char c : form) {
    const bool is_between = std::string_view(" []()|,=").find(c) != std::string_view::npos;
    if (!is_between) {
      word += c;
      continue;
    }
    end_word();
    text += c;
  }
  end_word();
  return text;
}

std::string synopsis(const Manual& manual) {
  std::string text = ".SH SYNOPSIS\n";
  for (const std::string& form : manual.synopsis)
    text += ".SY \"" + literal(manual.name) + "\"\n" + form_text(form) + "\n.YS\n";
  return text;
}

std::string description_section(const Manual& manual) {
  std::string text = ".SH DESCRIPTION\n";
  for (const Paragraph& paragraph : paragraphs(manual.description)) {
    text += ".PP\n";
    if (!paragraph.is_verbatim) {
      text += troff_text(paragraph.text) + "\n";
      continue;
    }
    text += ".nf\n";
    std::istringstream lines(paragraph.text);
    for (std::string line; std::getline(lines, line);) text += literal(line) + "\n";
    text += ".fi\n";
  }
  return text;
}

std::string list(const std::string& title, const std::vector<Manual::Line>& lines) {
  if (lines.empty()) return "";
  std::string text = ".SH " + title + "\n";
  for (const Manual::Line& line : lines)
    text += ".TP\n" + bold(line.name) + "\n" + troff_text(line.text) + "\n";
  return text;
}

std::string options_text(const std::vector<OptionGroup>& groups) {
  if (groups.empty()) return "";
  std::string text = ".SH OPTIONS\n";
  for (const OptionGroup& group : groups) {
    if (!group.title.empty() && group.title != "Options") text += ".SS " + troff_text(group.title) + "\n";
    for (const OptionEntry& option : group.options) {
      text += ".TP\n";
      if (option.letter) text += bold(std::string{'-', option.letter}) + ", ";
      text += bold("--" + option.name);
      if (!option.placeholder.empty()) text.append(" ").append(italic(option.placeholder));
      text.append("\n").append(troff_text(option.help));
      if (!option.default_text.empty()) text.append(" [").append(troff_text(option.default_text)).append("]");
      text += "\n";
    }
  }
  return text;
}

std::string see_also(const Manual& manual) {
  std::string text;
  for (const std::string& name : manual.see_also)
    text += (text.empty() ? ".SH SEE ALSO\n" : ",\n") + bold(page_name(name)) + "(1)";
  return text + (text.empty() ? "" : "\n");
}

}  // namespace

std::string troff_text(const std::string& text) {
  std::string out;
  bool is_word_start = true, is_option = false;
  for (std::size_t i = 0; i < text.size();) {
    const char32_t c = next_code_point(text, i);
    if (is_word_start) is_option = c == '-';
    if (out.empty() && (c == '.' || c == '\'')) out = "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-' && is_option)
      out += "\\-";
    else if (c < 0x80)
      out += static_cast<char>(c);
    else
      out += fmt::format("\\[u{:04X}]", static_cast<unsigned>(c));
    is_word_start = c < 0x80 && !std::isalnum(static_cast<int>(c)) && c != '-' && c != '_';
  }
  return out;
}

std::string man_page(const Manual& manual, const std::vector<OptionGroup>& options) {
  const std::string name = page_name(manual.name);
  return ".TH \"" + upper(name) + "\" 1 \"\" \"cps " CPS_VERSION "\" \"cps\"\n.ad l\n.nr HY 0\n" +  //
         ".SH NAME\n" + literal(name) + " \\- " + troff_text(manual.summary) + "\n" + synopsis(manual) +
         description_section(manual) + list("VERBS", manual.verbs) + options_text(options) +
         list("EXIT STATUS", manual.exit_status) + list("EXAMPLES", manual.examples) + see_also(manual);
}

}  // namespace cps
