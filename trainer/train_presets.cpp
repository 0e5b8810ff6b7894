#include "trainer/train_presets.h"

#include <array>
#include <stdexcept>

namespace cps {

std::span<const TrainPreset> train_presets() {
  static const std::array<TrainPreset, 2> presets{{
      {"demo", "some two hundred images in three minutes of two cores", {.epochs = 30, .minutes = 3}},
      {"smoke", "some thousand images in eighteen minutes of two cores", {.epochs = 36, .minutes = 18}},
  }};
  return presets;
}

const TrainOptions& train_preset(const std::string& name) {
  std::string known;
  for (const TrainPreset& preset : train_presets()) {
    if (preset.name == name) return preset.options;
    known += " " + preset.name;
  }
  throw std::runtime_error("preset '" + name + "': not known: choose one of" + known);
}

}  // namespace cps
