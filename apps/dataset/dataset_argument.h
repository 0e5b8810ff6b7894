#pragma once

#include <optional>
#include <string>

#include "apps/manual/manual.h"
#include "apps/verbs.h"

namespace cps {

/// The folder that a verb with no other argument is given; none if help was asked for, which is then printed.
/// Throws boost::program_options::error as parse_options() does.
std::optional<std::string> dataset_argument(const Arguments& arguments, const Manual& manual);

}  // namespace cps
