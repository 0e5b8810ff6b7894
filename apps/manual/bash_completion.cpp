#include "apps/manual/bash_completion.h"

#include <algorithm>

namespace cps {
namespace {

/// Until the entries: a list of what may follow the program, or else of what the verb takes.
constexpr const char* head = R"(# bash completion of PROGRAM, as PROGRAM --completion bash prints it
FUNCTION() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]-}
  local first=1 second='' candidates='' switches='' valued='' candidate IFS=$' \t\n'
  COMPREPLY=()
  # Bash cuts --option=value into three words.
  if [ "$word" = = ]; then
    word=''
  elif [ "$previous" = = ]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if [ "$verb" = help ] && [ "$COMP_CWORD" -gt 1 ]; then
    first=2
    verb=${COMP_WORDS[2]-}
  fi
  if [ "$COMP_CWORD" -gt $((first + 1)) ]; then second=${COMP_WORDS[first + 1]}; fi
  if [ "$COMP_CWORD" = "$first" ]; then
    verb=''
    candidates='VERBS help --help --version'
  fi
  case "$verb $second" in
)";

constexpr const char* foreign = R"(    NAMES)
      # The script of PROGRAM, beside this one, completes these.
      candidate=${BASH_SOURCE[0]%/*}/PROGRAM
      [ -r "$candidate" ] && . "$candidate" && FUNCTION
      return
      ;;
)";

constexpr const char* tail = R"(  esac
  if [ -z "$candidates" ]; then
    case " ${valued//_/-} " in
      *" ${previous//_/-} "*) ;; # a value of that option
      *) [[ $word == -* ]] && candidates="$switches $valued" ;;
    esac
  fi
  if [ -n "$candidates" ]; then
    # - and _ in the names of options mean the same.
    for candidate in $candidates; do
      if [[ ${candidate//_/-} == "${word//_/-}"* ]]; then COMPREPLY+=("$candidate"); fi
    done
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -o bashdefault -o default -F FUNCTION PROGRAM
)";

std::string function_name(std::string program) {
  std::replace(program.begin(), program.end(), '-', '_');
  return "_" + program;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string for_program(const char* text, const std::string& program) {
  return replaced(replaced(text, "PROGRAM", program), "FUNCTION", function_name(program));
}

std::string joined_names(const std::vector<Manual::Line>& lines) {
  std::string text;
  for (const Manual::Line& line : lines) text += (text.empty() ? "" : " ") + line.name;
  return text;
}

}  // namespace

std::string bash_head(const CompletionFrame& frame) {
  return replaced(for_program(head, frame.program), "VERBS", joined_names(frame.verbs));
}

std::string bash_entry(const Manual& manual, const std::vector<OptionGroup>& options) {
  const std::string words = manual.name.substr(manual.name.find(' ') + 1);  // after the program
  const bool is_nested = words.find(' ') != words.npos;
  std::string switches, valued;
  for (const OptionGroup& group : options)
    for (const OptionEntry& option : group.options) {
      std::string& list = option.placeholder.empty() ? switches : valued;
      if (option.letter) list += std::string{' ', '-', option.letter};
      list += " --" + option.name;
    }
  std::string text = "    '" + words + (is_nested ? "'" : " '*") + ")\n";
  if (!manual.verbs.empty()) text += "      candidates='" + joined_names(manual.verbs) + "'\n";
  return text + "      switches='" + switches + "'\n      valued='" + valued + "'\n      ;;\n";
}

std::string bash_tail(const CompletionFrame& frame) {
  std::string names;
  for (const std::string& verb : frame.foreign) names += (names.empty() ? "'" : " | '") + verb + " '*";
  const std::string elsewhere =
      names.empty() ? "" : for_program(replaced(foreign, "NAMES", names).c_str(), frame.foreign_program);
  return elsewhere + for_program(tail, frame.program);
}

}  // namespace cps
