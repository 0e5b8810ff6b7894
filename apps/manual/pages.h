#pragma once

#include <boost/program_options/options_description.hpp>
#include <functional>
#include <string>
#include <vector>

#include "apps/manual/manual.h"

/// What the build asks the programs for, so that man pages and completion come from the options themselves.
/// Help does not list these requests:
///
///   PROGRAM --man                    the names of its pages, one a line
///   PROGRAM --man PAGE               one of them
///   PROGRAM --completion bash|zsh    the completion of its command line
namespace cps {

struct Verb {
  std::string name, summary;
  std::function<int(const std::vector<std::string>&)> run;  ///< on the arguments after the verb
  std::vector<Manual::Line> verbs = {};                     ///< its own, if it has any
  std::string program = {};                                 ///< the other program that the verb runs, if so
};

/// A verb of this program, with name and summary of its manual.
Verb verb_of(const Manual& manual, int (*run)(const std::vector<std::string>&));

/// Names and summaries of the verbs, for the manual that lists them.
std::vector<Manual::Line> lines_of(const std::vector<Verb>& verbs);

/// The part of a verb in this: whether the arguments after it ask for its page or its entry in a completion,
/// which is then printed. `options` are all that the verb has.
bool print_page(const std::vector<std::string>& arguments, const Manual& manual,
                const boost::program_options::options_description& options);

/// Whether the arguments of the program ask for one of its pages or its completion, which is then printed. A
/// verb whose page has the name of the program's speaks for both. Throws boost::program_options::error for an
/// unknown page or shell.
bool print_pages(const std::vector<std::string>& arguments, const Manual& program,
                 const std::vector<Verb>& verbs);

}  // namespace cps
