#pragma once

#include <boost/program_options/options_description.hpp>
#include <string>
#include <vector>

namespace cps {

/// An option as its users see it: what help, man page and completion print.
struct OptionEntry {
  std::string name;               ///< without dashes: "out"
  char letter = 0;                ///< of the short form, "o"; 0 if there is none
  std::string placeholder = {};   ///< what stands for the value: "FILE"; empty if the option takes none
  std::string default_text = {};  ///< empty if there is no default, or if the help names it
  std::string help = {};          ///< a phrase without a full stop
};

struct OptionGroup {
  std::string title;
  std::vector<OptionEntry> options;
};

/// All options with the titles of their groups, in the order in which Boost prints them. A value that was
/// given no name is called BOOL, NUMBER or TEXT, by its type.
std::vector<OptionGroup> option_groups(const boost::program_options::options_description& options);

}  // namespace cps
