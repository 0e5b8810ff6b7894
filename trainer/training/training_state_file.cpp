#include "trainer/training/training_state_file.h"

#include <torch/serialize.h>

#include <sstream>
#include <stdexcept>

#include "trainer/network/tensor_file.h"
#include "trainer/network/weights.h"

namespace cps {
namespace {

/// Version 1 had no number, and the history without names.
constexpr std::int64_t state_version = 2;
/// 1 for a network trained in bfloat16. States from before this existed lack it and were trained in float32.
const std::string precision_name = "bfloat16";
const std::string network_prefix = "network.", average_prefix = "average.", history_prefix = "history.";

/// The tensors whose name begins with `prefix`, without it.
NamedTensors part_of(const NamedTensors& tensors, const std::string& prefix) {
  NamedTensors part;
  for (const auto& [name, tensor] : tensors)
    if (name.starts_with(prefix)) part[name.substr(prefix.size())] = tensor;
  return part;
}

void add_part(NamedTensors& tensors, const std::string& prefix, const NamedTensors& part) {
  for (const auto& [name, tensor] : part) tensors[prefix + name] = tensor;
}

/// One column for each field of the reports, under its name.
NamedTensors to_columns(const std::vector<EpochReport>& epochs) {
  std::map<std::string, std::vector<double>> columns;
  const EpochReport none;
  for_each_field(none, [&](const char* name, const auto&) { columns[name]; });
  for (const EpochReport& report : epochs)
    for_each_field(report, [&](const char* name, const auto& value) {
      columns[name].push_back(static_cast<double>(value));
    });
  NamedTensors tensors;
  for (const auto& [name, values] : columns) tensors[name] = torch::tensor(values, torch::kDouble);
  return tensors;
}

/// Throws std::out_of_range on a missing column.
std::vector<EpochReport> from_columns(const NamedTensors& columns) {
  std::vector<EpochReport> epochs(static_cast<std::size_t>(columns.at("epoch").numel()));
  for (std::size_t e = 0; e < epochs.size(); ++e)
    for_each_field(epochs[e], [&]<typename Field>(const char* name, Field& field) {
      field = static_cast<Field>(columns.at(name)[static_cast<std::int64_t>(e)].template item<double>());
    });
  return epochs;
}

torch::Tensor integer(std::int64_t value) {
  return torch::tensor(value, torch::kLong);
}

Precision precision_of(const NamedTensors& state) {
  const auto found = state.find(precision_name);
  const bool is_bfloat16 = found != state.end() && found->second.numel() == 1 && found->second.item<bool>();
  return is_bfloat16 ? Precision::bfloat16 : Precision::float32;
}

}  // namespace

void save_training_state(const TrainingState& state, const std::filesystem::path& file) {
  NamedTensors tensors;
  tensors["version"] = integer(state_version);
  add_part(tensors, network_prefix, weights_of(*state.network));
  if (state.average) add_part(tensors, average_prefix, weights_of(*state.average));
  std::ostringstream moments;
  move_moments(*state.optimizer, torch::kCPU);
  torch::save(*state.optimizer, moments);
  move_moments(*state.optimizer, state.network->device());
  const std::string bytes = moments.str();
  tensors["optimizer"] =
      torch::from_blob(const_cast<char*>(bytes.data()), {static_cast<long>(bytes.size())}, torch::kUInt8);
  if (state.network->training_precision == Precision::bfloat16) tensors[precision_name] = integer(1);
  tensors["planned_epochs"] = integer(state.planned_epochs);
  tensors["steps"] = integer(state.steps);
  add_part(tensors, history_prefix, to_columns(state.epochs));
  save_tensors(tensors, file);
}

TrainingState load_training_state(const TrainOptions& of_model, const std::filesystem::path& file) {
  const NamedTensors tensors = load_tensors(file);
  if (const auto version = tensors.find("version"); version == tensors.end() ||
                                                    version->second.numel() != 1 ||
                                                    version->second.item<std::int64_t>() != state_version)
    throw std::runtime_error(file.string() +
                             ": was written by another version of cps: train again without --resume");
  if (const Precision used = precision_of(tensors); used != of_model.precision)
    throw std::runtime_error(file.string() + ": precision: the training used " + to_string(used) +
                             " and model.json says " + to_string(of_model.precision) +
                             ": restore the file of this training");
  TrainOptions options = of_model;
  options.initial_weights.clear();  // the state holds what they have become
  TrainingState state = fresh_training_state(options);
  set_weights(*state.network, part_of(tensors, network_prefix), file);
  if (state.average) set_weights(*state.average, part_of(tensors, average_prefix), file);
  try {
    const torch::Tensor moments = tensors.at("optimizer");
    std::istringstream bytes(std::string(reinterpret_cast<const char*>(moments.data_ptr<std::uint8_t>()),
                                         static_cast<std::size_t>(moments.numel())));
    torch::load(*state.optimizer, bytes);
    state.planned_epochs = static_cast<int>(tensors.at("planned_epochs").item<std::int64_t>());
    state.steps = tensors.at("steps").item<std::int64_t>();
    state.epochs = from_columns(part_of(tensors, history_prefix));
  } catch (const std::exception&) {
    throw std::runtime_error(file.string() +
                             ": lacks the optimizer's state or the history: train again without --resume");
  }
  return state;
}

}  // namespace cps
