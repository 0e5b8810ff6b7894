#pragma once

#include <torch/optim/adamw.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "trainer/network/device.h"
#include "trainer/network/resnet.h"
#include "trainer/network/tensor_file.h"
#include "trainer/training/train.h"

namespace cps {

/// What changes while a network is trained.
struct TrainingState {
  std::shared_ptr<Network> network;
  std::shared_ptr<Network> average;  ///< running mean of its weights; null: none is kept
  std::unique_ptr<torch::optim::AdamW> optimizer;
  int planned_epochs = 0;
  std::int64_t steps = 0;
  std::vector<EpochReport> epochs;  ///< so far

  /// The network that is judged and kept.
  Network& judged() const { return average ? *average : *network; }
};

/// After a step: moves the running mean towards the network's weights, by 1 − decay, and faster at first
/// (decay at most (1 + steps) / (10 + steps)); what batch normalisation has counted is copied. Nothing
/// without a running mean.
void update_average(TrainingState& state, double decay);

/// The part of a model's options that its network is built by.
NetworkOptions network_options(const TrainOptions& options);

TrainingState fresh_training_state(const TrainOptions& options);

/// Parameters and buffers under torchvision's names.
NamedTensors weights_of(const Network& network);

/// Throws std::runtime_error that starts with `file` when a tensor is missing, left over, or of another
/// shape.
void set_weights(Network& network, const NamedTensors& weights, const std::filesystem::path& file);

/// Copies weights that a network of this architecture learned elsewhere, torchvision's on ImageNet for
/// instance. A first layer for three colours becomes one for gray by the sum over them, which is what it
/// makes of a gray picture; edges, where the network sees them, count for nothing at first. A last layer of
/// another shape is left as it is. Throws std::runtime_error that starts with `file` where anything else is
/// missing or of another shape.
void start_from(Network& network, NamedTensors weights, const std::filesystem::path& file);

/// Networks and AdamW's moments.
void move_to(TrainingState& state, Device device);

/// What lies on another device is written as the CPU's, so that any machine can go on.
void save_training_state(const TrainingState& state, const std::filesystem::path& file);

/// Restores what save_training_state() wrote, on the CPU, for a network of the same options.
TrainingState load_training_state(const TrainOptions& options, const std::filesystem::path& file);

}  // namespace cps
