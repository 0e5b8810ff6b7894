#pragma once

#include <torch/optim/adamw.h>

#include <memory>
#include <vector>

#include "trainer/model/train_options.h"
#include "trainer/network/device.h"
#include "trainer/network/resnet.h"
#include "trainer/training/epoch_report.h"

namespace cps {

/// Everything that changes while a network is trained.
struct TrainingState {
  std::shared_ptr<Network> network;
  std::shared_ptr<Network> average;  ///< running mean of its weights; null: none is kept
  std::unique_ptr<torch::optim::AdamW> optimizer;
  int planned_epochs = 0;
  std::int64_t steps = 0;
  std::vector<EpochReport> epochs;  ///< so far

  /// The network that is validated and saved.
  Network& judged() const { return average ? *average : *network; }
};

/// The state before the first step, on the CPU: weights drawn from options.seed, or read from
/// options.initial_weights; they do not depend on options.precision, which must not be `automatic`. Throws
/// std::runtime_error with one line if that file cannot be used.
TrainingState fresh_training_state(const TrainOptions& options);

/// Updates the running mean of the weights after a step: it moves towards the network's weights by the factor
/// 1 − decay, and faster at first (decay is at most (1 + steps) / (10 + steps)). The statistics of batch
/// normalisation are copied. Does nothing if no running mean is kept.
void update_average(TrainingState& state, double decay);

/// Moves the moments of AdamW, which exist after the first step.
void move_moments(torch::optim::AdamW& optimizer, torch::Device to);

/// Moves the networks and the optimizer's moments.
void move_to(TrainingState& state, Device device);

}  // namespace cps
