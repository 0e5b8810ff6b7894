#include "trainer/training/training_state.h"

#include <algorithm>

#include "random/counter_hash.h"
#include "trainer/model/make_network.h"
#include "trainer/network/autocast.h"
#include "trainer/network/weights.h"

namespace cps {

TrainingState fresh_training_state(const TrainOptions& options) {
  torch::manual_seed(mix64(options.seed));
  TrainingState state;
  state.network = make_network(options);
  if (!options.initial_weights.empty())
    start_from(*state.network, load_tensors(options.initial_weights), options.initial_weights);
  if (options.ema_decay > 0) {
    state.average = make_network(options);
    set_weights(*state.average, weights_of(*state.network), "");
  }
  state.network->training_precision = options.precision;
  if (options.precision == Precision::bfloat16) use_channels_last(*state.network);
  state.optimizer = std::make_unique<torch::optim::AdamW>(
      state.network->parameters(),
      torch::optim::AdamWOptions(options.learning_rate).weight_decay(options.weight_decay));
  state.planned_epochs = options.epochs;
  return state;
}

void move_moments(torch::optim::AdamW& optimizer, torch::Device to) {
  for (auto& [parameter, state] : optimizer.state()) {
    auto& moments = static_cast<torch::optim::AdamWParamState&>(*state);
    moments.exp_avg(moments.exp_avg().to(to));
    moments.exp_avg_sq(moments.exp_avg_sq().to(to));
  }
}

void update_average(TrainingState& state, double decay) {
  if (!state.average) return;
  const torch::NoGradGuard no_gradients;
  const double steps = static_cast<double>(state.steps), keep = std::min(decay, (1 + steps) / (10 + steps));
  const auto mean = state.average->parameters(), now = state.network->parameters();
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i].mul_(keep).add_(now[i], 1 - keep);
  const auto kept = state.average->buffers(), counted = state.network->buffers();
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i].copy_(counted[i]);
}

void move_to(TrainingState& state, Device device) {
  const torch::Device to = to_torch(device);
  state.network->to(to);
  if (state.average) state.average->to(to);
  move_moments(*state.optimizer, to);
}

}  // namespace cps
