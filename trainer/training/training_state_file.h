#pragma once

#include <filesystem>

#include "trainer/training/training_state.h"

/// state.pt: what a resumed training starts from.
namespace cps {

/// Writes the state by atomic rename. Tensors on another device are written as CPU tensors, so any machine
/// can continue.
void save_training_state(const TrainingState& state, const std::filesystem::path& file);

/// Reads what save_training_state() wrote, for a network of the same options; the state is on the CPU. Throws
/// std::runtime_error with one line if the file is missing, damaged, of another version, or of a training in
/// another precision.
TrainingState load_training_state(const TrainOptions& options, const std::filesystem::path& file);

}  // namespace cps
