#pragma once

#include <cstdint>
#include <vector>

#include "sampler/plan/plan.h"

namespace cps {

/// The scenes in which the views (ascending) lie: indices into plan.scenes, ascending, each once.
std::vector<int> scenes_of(const Plan& plan, const std::vector<std::int64_t>& views);

/// Draws the places of some views (ascending) of an outlined plan and adds them to its tally. A place does
/// not depend on which others are drawn. Loads the scenes of these views and no others, each once, one in
/// memory at a time, and notes in plan.scenes what their files say. The files must exist. Throws
/// std::runtime_error if a scene has too few streets for three parts or no free places.
void place_views(Plan& plan, const std::vector<std::int64_t>& views, const LoadDrivenScene& load);

}  // namespace cps
