#pragma once

#include <string>

#include "trainer/calibration/targets.h"
#include "trainer/onnx/onnx_model.h"

namespace cps {

/// What a model says of each output, in their order: the unit of calibration.json, and a short description.
struct LabelOutput {
  const char *unit, *description;
};
extern const std::array<LabelOutput, output_count> label_outputs;

/// Adds the way from standardised outputs to the numbers of calibration.json, and these as the graph's
/// outputs: output_names, each [N], in the units of label_outputs. `standardised` is the name of a value [N,
/// 8] in `space`, `size` that of a value [N, 2], height and width of the original images in pixels.
void add_label_outputs(OnnxGraph& graph, const std::string& standardised, const std::string& size,
                       const Standardisation& by, TargetSpace space);

}  // namespace cps
