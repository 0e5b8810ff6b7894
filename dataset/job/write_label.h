#pragma once

#include <filesystem>

#include "sampler/plan/plan.h"

namespace cps {

/// Writes the group's calibration.json, and before it the mask that it names, unless both exist; existing
/// ones are complete and of the same job. A label that an older program wrote is replaced by today's.
void write_label(const std::filesystem::path& root, const Plan& plan, const PlannedGroup& group);

}  // namespace cps
