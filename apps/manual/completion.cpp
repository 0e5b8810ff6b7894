#include "apps/manual/completion.h"

#include <boost/program_options/errors.hpp>

#include "apps/manual/bash_completion.h"
#include "apps/manual/zsh_completion.h"

namespace cps {

Shell shell_from_string(const std::string& word) {
  if (word == "bash") return Shell::bash;
  if (word == "zsh") return Shell::zsh;
  throw boost::program_options::error("--completion " + word + ": must be bash or zsh");
}

std::string completion_head(Shell shell, const CompletionFrame& frame) {
  return shell == Shell::bash ? bash_head(frame) : zsh_head(frame);
}

std::string completion_entry(Shell shell, const Manual& manual, const std::vector<OptionGroup>& options) {
  return shell == Shell::bash ? bash_entry(manual, options) : zsh_entry(manual, options);
}

std::string completion_tail(Shell shell, const CompletionFrame& frame) {
  return shell == Shell::bash ? bash_tail(frame) : zsh_tail(frame);
}

}  // namespace cps
