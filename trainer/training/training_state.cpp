#include "trainer/training/training_state.h"

#include <torch/serialize.h>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "random/counter_hash.h"

namespace cps {
namespace {

const std::string network_prefix = "network.", average_prefix = "average.";

/// The numbers of an epoch, in the order they are stored.
std::vector<double> numbers(const EpochReport& r) {
  return {static_cast<double>(r.epoch),
          static_cast<double>(r.planned_epochs),
          r.learning_rate,
          r.training_loss,
          r.validation_loss,
          r.validation_cosine,
          r.validation_hfov_mae_deg,
          r.images_per_second,
          r.loader_share,
          r.seconds_left,
          static_cast<double>(r.is_best)};
}

EpochReport report_from(const double* n) {
  return {static_cast<int>(n[0]),
          static_cast<int>(n[1]),
          n[2],
          n[3],
          n[4],
          n[5],
          n[6],
          n[7],
          n[8],
          n[9],
          n[10] != 0};
}

/// The tensors whose name begins with `prefix`, without it.
NamedTensors part_of(const NamedTensors& tensors, const std::string& prefix) {
  NamedTensors part;
  for (const auto& [name, tensor] : tensors)
    if (name.starts_with(prefix)) part[name.substr(prefix.size())] = tensor;
  return part;
}

void move_moments(torch::optim::AdamW& optimizer, torch::Device to) {
  for (auto& [parameter, state] : optimizer.state()) {
    auto& moments = static_cast<torch::optim::AdamWParamState&>(*state);
    moments.exp_avg(moments.exp_avg().to(to));
    moments.exp_avg_sq(moments.exp_avg_sq().to(to));
  }
}

}  // namespace

NetworkOptions network_options(const TrainOptions& options) {
  return {.dropout = options.dropout,
          .size_features = options.size_features,
          .edge_channel = options.edge_channel};
}

TrainingState fresh_training_state(const TrainOptions& options) {
  torch::manual_seed(mix64(options.seed));
  TrainingState state;
  state.network = make_resnet(*find_architecture(options.architecture), network_options(options));
  if (!options.initial_weights.empty())
    start_from(*state.network, load_tensors(options.initial_weights), options.initial_weights);
  if (options.ema_decay > 0) {
    state.average = make_resnet(*find_architecture(options.architecture), network_options(options));
    set_weights(*state.average, weights_of(*state.network), "");
  }
  state.optimizer = std::make_unique<torch::optim::AdamW>(
      state.network->parameters(),
      torch::optim::AdamWOptions(options.learning_rate).weight_decay(options.weight_decay));
  state.planned_epochs = options.epochs;
  return state;
}

NamedTensors weights_of(const Network& network) {
  NamedTensors weights;
  for (const auto& parameter : network.named_parameters()) weights[parameter.key()] = parameter.value();
  for (const auto& buffer : network.named_buffers()) weights[buffer.key()] = buffer.value();
  return weights;
}

void set_weights(Network& network, const NamedTensors& weights, const std::filesystem::path& file) {
  const torch::NoGradGuard no_gradients;
  const NamedTensors own = weights_of(network);
  for (const auto& [name, tensor] : own) {
    const auto found = weights.find(name);
    if (found == weights.end() || found->second.sizes() != tensor.sizes())
      throw std::runtime_error(file.string() + ": " + name +
                               ": missing or of another shape: these weights belong to another architecture");
    tensor.copy_(found->second);
  }
  if (weights.size() != own.size())
    throw std::runtime_error(
        file.string() + ": holds tensors this network lacks: the weights belong to another architecture");
}

void start_from(Network& network, NamedTensors weights, const std::filesystem::path& file) {
  NamedTensors own = weights_of(network);
  if (const auto first = weights.find("conv1.weight"); first != weights.end() && first->second.dim() == 4) {
    torch::Tensor& kernels = first->second;
    if (kernels.size(1) == 3) kernels = kernels.sum(1, true);
    if (kernels.size(1) == 1 && own["conv1.weight"].size(1) == 2)
      kernels = torch::cat({kernels, torch::zeros_like(kernels)}, 1);
  }
  for (const char* last : {"fc.weight", "fc.bias"})
    if (const auto found = weights.find(last);
        found == weights.end() || found->second.sizes() != own[last].sizes())
      weights[last] = own[last].detach().clone();
  set_weights(network, weights, file);
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

void save_training_state(const TrainingState& state, const std::filesystem::path& file) {
  NamedTensors tensors;
  for (const auto& [name, tensor] : weights_of(*state.network)) tensors[network_prefix + name] = tensor;
  if (state.average)
    for (const auto& [name, tensor] : weights_of(*state.average)) tensors[average_prefix + name] = tensor;
  std::ostringstream moments;
  move_moments(*state.optimizer, torch::kCPU);
  torch::save(*state.optimizer, moments);
  move_moments(*state.optimizer, state.network->device());
  const std::string bytes = moments.str();
  tensors["optimizer"] =
      torch::from_blob(const_cast<char*>(bytes.data()), {static_cast<long>(bytes.size())}, torch::kUInt8);
  std::vector<double> history{static_cast<double>(state.planned_epochs), static_cast<double>(state.steps)};
  for (const EpochReport& report : state.epochs)
    for (double number : numbers(report)) history.push_back(number);
  tensors["history"] = torch::tensor(history, torch::kDouble);
  save_tensors(tensors, file);
}

TrainingState load_training_state(const TrainOptions& of_model, const std::filesystem::path& file) {
  TrainOptions options = of_model;
  options.initial_weights.clear();  // what was learned since is in `file`
  TrainingState state = fresh_training_state(options);
  const NamedTensors tensors = load_tensors(file);
  set_weights(*state.network, part_of(tensors, network_prefix), file);
  if (state.average) set_weights(*state.average, part_of(tensors, average_prefix), file);
  try {
    const torch::Tensor moments = tensors.at("optimizer"), history = tensors.at("history");
    std::istringstream bytes(std::string(reinterpret_cast<const char*>(moments.data_ptr<std::uint8_t>()),
                                         static_cast<std::size_t>(moments.numel())));
    torch::load(*state.optimizer, bytes);
    const double* number = history.data_ptr<double>();
    state.planned_epochs = static_cast<int>(*number++);
    state.steps = static_cast<std::int64_t>(*number++);
    const std::int64_t per_epoch = static_cast<std::int64_t>(numbers({}).size()), count = history.numel() - 2;
    if (count % per_epoch != 0) throw std::runtime_error("history");
    for (std::int64_t i = 0; i < count; i += per_epoch) {
      state.epochs.push_back(report_from(number + i));
      if (state.epochs.back().epoch != static_cast<int>(state.epochs.size()))
        throw std::runtime_error("history");
    }
  } catch (const std::exception&) {
    throw std::runtime_error(file.string() + ": lacks the optimizer's state or is another version's: " +
                             "train again without --resume");
  }
  return state;
}

}  // namespace cps
