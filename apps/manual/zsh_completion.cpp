#include "apps/manual/zsh_completion.h"

namespace cps {
namespace {

/// In single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// An explanation of _arguments: in brackets, those of the text escaped.
std::string explanation(const std::string& text) {
  std::string out = "[";
  for (const char c : text) {
    if (c == '[' || c == ']' || c == '\\') out += '\\';
    out += c;
  }
  return out + "]";
}

bool is_path(const std::string& placeholder) {
  for (const char* path : {"FILE", "FOLDER", "DATASET", "MODEL", "PATH", "LENS", "SKY", "TEXT", "LIST"})
    if (placeholder == path) return true;
  return false;
}

/// An option as an argument of _arguments.
std::string spec(const OptionEntry& option) {
  const bool has_value = !option.placeholder.empty();
  const std::string value =
      has_value ? ":" + option.placeholder + (is_path(option.placeholder) ? ":_files" : ": ") : "";
  const std::string rest = explanation(option.help) + value;
  const std::string name = "--" + option.name + (has_value ? "=" : "");
  if (option.letter == 0) return quoted(name + rest);
  const std::string letter{'-', option.letter};
  return quoted("(" + letter + " --" + option.name + ")") + "{" + letter + (has_value ? "+" : "") + "," +
         name + "}" + quoted(rest);
}

std::string described(const std::vector<Manual::Line>& verbs, const std::string& indent) {
  std::string text;
  for (const Manual::Line& verb : verbs) text += indent + quoted(verb.name + ":" + verb.text) + "\n";
  return text;
}

}  // namespace

std::string zsh_head(const CompletionFrame& frame) {
  const std::string& name = frame.program;
  return "#compdef " + name + "\n# zsh completion of " + name + ", as " + name +
         " --completion zsh prints it\n_" + name + R"(() {
  local curcontext=$curcontext first=2 second= depth=1
  local -a specs verbs=(
)" + described(frame.verbs, "    ") +
         R"(    'help:describe a verb and its options'
  )
  [[ $words[2] == help ]] && (( CURRENT > 2 )) && first=3
  if (( CURRENT == first )); then
    _describe -t verbs verb verbs
    return
  fi
  (( CURRENT > first + 1 )) && second=$words[first+1]
  case "$words[first] $second" in
)";
}

std::string zsh_entry(const Manual& manual, const std::vector<OptionGroup>& options) {
  const std::string words = manual.name.substr(manual.name.find(' ') + 1);  // after the program
  const bool is_nested = words.find(' ') != words.npos;
  std::string text = "    '" + words + (is_nested ? "'" : " '*") + ")\n";
  if (!manual.verbs.empty())
    return text + "      verbs=(\n" + described(manual.verbs, "        ") +
           "      )\n      _describe -t verbs verb verbs\n      return\n      ;;\n";
  if (is_nested) text += "      depth=2\n";
  text += "      specs=(\n";
  for (const OptionGroup& group : options)
    for (const OptionEntry& option : group.options) text += "        " + spec(option) + "\n";
  return text + "      )\n      ;;\n";
}

std::string zsh_tail(const CompletionFrame& frame) {
  std::string text;
  for (const std::string& verb : frame.foreign) text += (text.empty() ? "    '" : " | '") + verb + " '*";
  if (!text.empty())
    text += ")\n      (( $+functions[_" + frame.foreign_program + "] )) && _" + frame.foreign_program +
            "\n      return\n      ;;\n";
  return text + R"(  esac
  (( depth += first - 2 ))
  shift $depth words
  (( CURRENT -= depth ))
  # - and _ in the names of options mean the same.
  _arguments -M 'm:{_-}={-_} r:|[_-]=* r:|=*' $specs '*:file:_files'
}
if [ "$funcstack[1]" = "_)" +
         frame.program + "\" ]; then _" + frame.program + " \"$@\"; else compdef _" + frame.program + " " +
         frame.program + "; fi\n";
}

}  // namespace cps
