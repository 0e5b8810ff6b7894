#pragma once

#include <span>
#include <string>

#include "trainer/model/train_options.h"

namespace cps {

struct TrainPreset {
  std::string name, purpose;
  TrainOptions options;
};

/// To add one: a row in train_presets.cpp.
std::span<const TrainPreset> train_presets();

/// Throws std::runtime_error that lists the known ones.
const TrainOptions& train_preset(const std::string& name);

}  // namespace cps
