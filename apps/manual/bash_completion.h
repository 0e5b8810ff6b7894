#pragma once

#include "apps/manual/completion.h"

/// The parts of a program's script for bash; see completion.h.
namespace cps {

std::string bash_head(const CompletionFrame& frame);
std::string bash_entry(const Manual& manual, const std::vector<OptionGroup>& options);
std::string bash_tail(const CompletionFrame& frame);

}  // namespace cps
