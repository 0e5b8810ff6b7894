#pragma once

#include <torch/optim/adamw.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "trainer/resnet.h"
#include "trainer/tensor_file.h"
#include "trainer/train.h"

namespace cps {

/// What changes while a network is trained.
struct TrainingState {
  std::shared_ptr<Network> network;
  std::unique_ptr<torch::optim::AdamW> optimizer;
  int planned_epochs = 0;
  std::vector<EpochReport> epochs;  ///< so far
};

TrainingState fresh_training_state(const TrainOptions& options);

/// Parameters and buffers under torchvision's names.
NamedTensors weights_of(const Network& network);

/// Throws std::runtime_error that starts with `file` when a tensor is missing, left over, or of another
/// shape.
void set_weights(Network& network, const NamedTensors& weights, const std::filesystem::path& file);

void save_training_state(const TrainingState& state, const std::filesystem::path& file);

/// Restores what save_training_state() wrote, for a network of the same options.
TrainingState load_training_state(const TrainOptions& options, const std::filesystem::path& file);

}  // namespace cps
