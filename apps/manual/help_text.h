#pragma once

#include <string>
#include <vector>

#include "apps/manual/manual.h"
#include "apps/manual/option_groups.h"

namespace cps {

/// What --help prints, 80 columns wide.
std::string help_text(const Manual& manual, const std::vector<OptionGroup>& options);

}  // namespace cps
