#pragma once

#include <span>
#include <string>

#include "trainer/model/train_options.h"

namespace cps {

/// Named options for `cps train --preset`.
struct TrainPreset {
  std::string name, purpose;
  TrainOptions options;
};

/// All presets. To add one, add a row in train_presets.cpp.
std::span<const TrainPreset> train_presets();

/// The options of the preset of that name. Throws std::runtime_error that lists the known presets.
const TrainOptions& train_preset(const std::string& name);

}  // namespace cps
