#pragma once

#include <string>
#include <vector>

#include "apps/manual/manual.h"
#include "apps/manual/option_groups.h"

namespace cps {

/// The page of section 1 as man reads it: troff with the macros of man(7), in ASCII. The same for every
/// commit of a version.
std::string man_page(const Manual& manual, const std::vector<OptionGroup>& options);

/// Plain text as troff shows it: backslashes and whatever is not ASCII written as escapes, dashes of options
/// as dashes that can be copied, and a first character that troff would take for a request guarded.
std::string troff_text(const std::string& text);

}  // namespace cps
