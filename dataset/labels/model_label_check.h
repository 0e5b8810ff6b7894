#pragma once

#include <filesystem>

#include "dataset/labels/label_check.h"
#include "dataset/labels/model_label.h"

namespace cps {

/// Computes again what a label of another family than Brown–Conrady claims: the lens is one-to-one where the
/// image shows something, its smallest scale, the angles that are seen, and the mask beside the label in the
/// leaf folder `leaf`, pixel for pixel. There is no master, so rim_margin_px is infinite.
LabelCheck check_model_label(const ModelLabel& label, const std::filesystem::path& leaf);

}  // namespace cps
