#pragma once

#include "dataset/labels/label.h"
#include "sampler/plan/plan.h"

namespace cps {

/// `cps 0.1.0`
std::string generator_name();

/// The label of a planned group: what was drawn, the camera after the crop, the angles that the distorted
/// image really sees, and the certificate on the base's frame, computed anew here. Throws std::runtime_error
/// if the lens is not certified, which no drawn lens should be.
Label group_label(const Plan& plan, const PlannedGroup& group);

}  // namespace cps
