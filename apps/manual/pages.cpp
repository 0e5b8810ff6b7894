#include "apps/manual/pages.h"

#include <algorithm>
#include <boost/program_options/errors.hpp>
#include <iostream>

#include "apps/manual/completion.h"
#include "apps/manual/man_page.h"
#include "apps/manual/option_groups.h"

namespace cps {
namespace {

/// A page that a verb prints.
struct VerbPage {
  std::string name;
  const Verb* verb;
  std::vector<std::string> words;  ///< after the verb
};

/// Those of the verbs that this program has, verbs of verbs before the verb that lists them.
std::vector<VerbPage> verb_pages(const std::vector<Verb>& verbs) {
  std::vector<VerbPage> pages;
  for (const Verb& verb : verbs) {
    if (!verb.program.empty()) continue;
    for (const Manual::Line& part : verb.verbs)
      pages.push_back({page_name("cps " + verb.name + " " + part.name), &verb, {part.name}});
    pages.push_back({page_name("cps " + verb.name), &verb, {}});
  }
  return pages;
}

void ask(const VerbPage& page, const std::vector<std::string>& request) {
  std::vector<std::string> arguments = page.words;
  arguments.insert(arguments.end(), request.begin(), request.end());
  page.verb->run(arguments);
}

void print_completion(Shell shell, const std::string& word, const Manual& program,
                      const std::vector<Verb>& verbs) {
  CompletionFrame frame{.program = program.name, .verbs = lines_of(verbs)};
  for (const Verb& verb : verbs) {
    if (verb.program.empty()) continue;
    frame.foreign.push_back(verb.name);
    frame.foreign_program = verb.program;
  }
  std::cout << completion_head(shell, frame);
  for (const VerbPage& page : verb_pages(verbs)) ask(page, {"--completion", word});
  std::cout << completion_tail(shell, frame);
}

}  // namespace

Verb verb_of(const Manual& manual, int (*run)(const std::vector<std::string>&)) {
  return {.name = manual.name.substr(manual.name.rfind(' ') + 1),
          .summary = manual.summary,
          .run = run,
          .verbs = manual.verbs};
}

std::vector<Manual::Line> lines_of(const std::vector<Verb>& verbs) {
  std::vector<Manual::Line> lines;
  for (const Verb& verb : verbs) lines.push_back({verb.name, verb.summary});
  return lines;
}

bool print_page(const std::vector<std::string>& arguments, const Manual& manual,
                const boost::program_options::options_description& options) {
  if (arguments.size() == 1 && arguments[0] == "--man")
    std::cout << man_page(manual, option_groups(options));
  else if (arguments.size() == 2 && arguments[0] == "--completion")
    std::cout << completion_entry(shell_from_string(arguments[1]), manual, option_groups(options));
  else
    return false;
  return true;
}

bool print_pages(const std::vector<std::string>& arguments, const Manual& program,
                 const std::vector<Verb>& verbs) {
  if (arguments.empty() || arguments.size() > 2) return false;
  if (arguments[0] == "--completion") {
    const std::string word = arguments.size() > 1 ? arguments[1] : "";
    print_completion(shell_from_string(word), word, program, verbs);
    return true;
  }
  if (arguments[0] != "--man") return false;
  const std::vector<VerbPage> pages = verb_pages(verbs);
  const std::string own_page = page_name(program.name);
  const auto page_named = [&](const std::string& name) {
    return std::find_if(pages.begin(), pages.end(), [&](const VerbPage& page) { return page.name == name; });
  };
  const bool has_own = page_named(own_page) == pages.end();
  if (arguments.size() == 1) {
    if (has_own) std::cout << own_page << "\n";
    for (const VerbPage& page : pages) std::cout << page.name << "\n";
  } else if (const auto page = page_named(arguments[1]); page != pages.end()) {
    ask(*page, {"--man"});
  } else if (has_own && arguments[1] == own_page) {
    std::cout << man_page(program, {});
  } else {
    throw boost::program_options::error("--man " + arguments[1] + ": is no page; --man lists them");
  }
  return true;
}

}  // namespace cps
