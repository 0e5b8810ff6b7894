#include "apps/manual/help_text.h"

#include <algorithm>

#include "apps/manual/paragraphs.h"

namespace cps {
namespace {

constexpr std::size_t width = 80, max_term_width = 30;

/// The form of a synopsis, broken between its bracketed parts, not inside them.
std::string filled_form(std::string form, std::size_t column) {
  constexpr char no_break = '\x01';
  int depth = 0;
  for (char& c : form) {
    depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
    if (depth > 0 && c == ' ') c = no_break;
  }
  std::string text = filled(form, width, column, column);
  std::replace(text.begin(), text.end(), no_break, ' ');
  return text;
}

std::string usage(const Manual& manual) {
  const std::string head = "Usage: ";
  std::string text;
  for (const std::string& form : manual.synopsis) {
    const std::string start = (text.empty() ? head : std::string(head.size(), ' ')) + manual.name + " ";
    text += start + filled_form(form, start.size()) + "\n";
  }
  return text;
}

std::string description(const Manual& manual) {
  std::string text;
  for (const Paragraph& paragraph : paragraphs(manual.description))
    text += "\n" + (paragraph.is_verbatim ? paragraph.text : filled(paragraph.text, width, 0, 0)) + "\n";
  return text;
}

/// Two columns: terms, and what they mean. A term wider than its column has a line of its own.
std::string table(const std::vector<Manual::Line>& rows) {
  std::size_t widest = 0;
  for (const Manual::Line& row : rows)
    if (length(row.name) <= max_term_width) widest = std::max(widest, length(row.name));
  const std::size_t column = 2 + widest + 2;
  std::string text;
  for (const Manual::Line& row : rows) {
    text += "  " + row.name;
    text += length(row.name) > widest ? "\n" + std::string(column, ' ')
                                      : std::string(column - 2 - length(row.name), ' ');
    text += filled(row.text, width, column, column) + "\n";
  }
  return text;
}

std::string option_table(const OptionGroup& group) {
  std::vector<Manual::Line> rows;
  for (const OptionEntry& option : group.options) {
    std::string term = option.letter ? std::string{'-', option.letter, ',', ' '} : "    ";
    term += "--" + option.name + (option.placeholder.empty() ? "" : " " + option.placeholder);
    rows.push_back(
        {term, option.help + (option.default_text.empty() ? "" : " [" + option.default_text + "]")});
  }
  return "\n" + (group.title.empty() ? "Options" : group.title) + ":\n" + table(rows);
}

std::string exit_status(const Manual& manual) {
  std::string text = "Exit status:";
  for (const Manual::Line& line : manual.exit_status)
    text += (&line == &manual.exit_status.front() ? " " : "; ") + line.name + " " + line.text;
  return "\n" + filled(text + ".", width, 0, 0) + "\n";
}

std::string examples(const Manual& manual) {
  if (manual.examples.empty()) return "";
  std::string text = "\nExamples:\n";
  for (const Manual::Line& example : manual.examples)
    text += "  " + example.name + "\n      " + filled(example.text, width, 6, 6) + "\n";
  return text;
}

}  // namespace

std::string help_text(const Manual& manual, const std::vector<OptionGroup>& options) {
  std::string text = manual.name + ": " + manual.summary + "\n\n" + usage(manual) + description(manual);
  if (!manual.verbs.empty()) text += "\nVerbs:\n" + table(manual.verbs);
  for (const OptionGroup& group : options) text += option_table(group);
  return text + exit_status(manual) + examples(manual);
}

}  // namespace cps
