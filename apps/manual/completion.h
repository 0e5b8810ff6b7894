#pragma once

#include <string>
#include <vector>

#include "apps/manual/manual.h"
#include "apps/manual/option_groups.h"

/// Completion of a program's command line in bash and zsh: a script that begins with a head, has an entry for
/// each verb, and ends with a tail.
namespace cps {

enum class Shell { bash, zsh };

/// Throws boost::program_options::error for another word.
Shell shell_from_string(const std::string& word);

/// What a program's script says of all verbs together.
struct CompletionFrame {
  std::string program;                    ///< "cps"
  std::vector<Manual::Line> verbs;        ///< all of them
  std::vector<std::string> foreign = {};  ///< those that `foreign_program` completes
  std::string foreign_program = {};
};

std::string completion_head(Shell shell, const CompletionFrame& frame);

/// The entry of a verb with options, or of one with verbs of its own.
std::string completion_entry(Shell shell, const Manual& manual, const std::vector<OptionGroup>& options);

std::string completion_tail(Shell shell, const CompletionFrame& frame);

}  // namespace cps
