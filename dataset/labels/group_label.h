#pragma once

#include <string>

#include "dataset/labels/label.h"
#include "dataset/labels/model_label.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Program and version, `cps 0.1.0`.
std::string generator_name();

/// What a drawn lens and its crop decide of a label: the final camera, the angles that the distorted image
/// really sees, and the certificate on the base's frame, computed again here. Rig camera, part and seed are
/// the caller's. Throws std::runtime_error with one line if the lens is not certified, which no drawn lens
/// should be.
Label lens_label(const DrawnLens& lens, const LensBounds& bounds);

/// The label of a planned group. Throws as lens_label() does, the group's folder first.
Label group_label(const Plan& plan, const PlannedGroup& group);

/// The label of a planned group with a lens of another family. `is_masked`: whether valid_mask() gives its
/// images a mask. Throws as model_label() and masked_model_label() do, the group's folder first.
ModelLabel group_model_label(const Plan& plan, const PlannedGroup& group, bool is_masked);

}  // namespace cps
