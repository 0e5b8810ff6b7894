#pragma once

#include "apps/manual/completion.h"

/// The parts of a program's script for zsh; see completion.h.
namespace cps {

std::string zsh_head(const CompletionFrame& frame);
std::string zsh_entry(const Manual& manual, const std::vector<OptionGroup>& options);
std::string zsh_tail(const CompletionFrame& frame);

}  // namespace cps
