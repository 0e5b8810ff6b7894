#pragma once

#include <string>
#include <vector>

namespace cps {

/// What --help and the man page say of a program or of one of its verbs, besides the options, which describe
/// themselves. Texts are plain; both pages break their lines anew.
struct Manual {
  struct Line {
    std::string name, text;
  };

  std::string name;                   ///< as it is typed: "cps", "cps city", "cps lens check"
  std::string summary;                ///< one line that begins with a verb, without a full stop
  std::vector<std::string> synopsis;  ///< what follows the name, one for each form
  std::string description = {};       ///< paragraphs, separated by empty lines
  std::vector<Line> verbs = {};       ///< of a program, or of a verb that has verbs of its own
  std::vector<Line> exit_status = {{"0", "done"}, {"1", "failed"}, {"2", "wrong usage"}};
  std::vector<Line> examples = {};         ///< a whole command and what it does
  std::vector<std::string> see_also = {};  ///< names of other manuals
};

/// The man page's name: "cps-lens-check" for "cps lens check".
std::string page_name(const std::string& manual_name);

}  // namespace cps
