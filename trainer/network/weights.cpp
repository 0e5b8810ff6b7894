#include "trainer/network/weights.h"

#include <stdexcept>

namespace cps {

NamedTensors weights_of(const Network& network) {
  NamedTensors weights;
  for (const auto& parameter : network.named_parameters()) weights[parameter.key()] = parameter.value();
  for (const auto& buffer : network.named_buffers()) weights[buffer.key()] = buffer.value();
  return weights;
}

NamedTensors half_weights_of(const Network& network, const std::filesystem::path& file) {
  NamedTensors weights = weights_of(network);
  for (const auto& parameter : network.named_parameters()) {
    const torch::Tensor half = parameter.value().detach().to(torch::kHalf);
    if (!half.isfinite().all().item<bool>())
      throw std::runtime_error(file.string() + ": " + parameter.key() +
                               ": holds a number that float16 cannot (its largest is 65504): keep the "
                               "float32 weights");
    weights[parameter.key()] = half;
  }
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
        file.string() +
        ": holds tensors that this network lacks: the weights belong to another architecture");
}

void start_from(Network& network, NamedTensors weights, const std::filesystem::path& file) {
  NamedTensors own = weights_of(network);
  if (const auto first = weights.find("conv1.weight"); first != weights.end() && first->second.dim() == 4) {
    torch::Tensor& kernels = first->second;
    if (kernels.size(1) == 3) kernels = kernels.sum(1, true, torch::kFloat);
    if (kernels.size(1) == 1 && own["conv1.weight"].size(1) == 2)
      kernels = torch::cat({kernels, torch::zeros_like(kernels)}, 1);
  }
  for (const auto& [name, tensor] : own)
    if ((name.starts_with("orientation.") || name.starts_with("edge_weights")) && !weights.contains(name))
      weights[name] = torch::zeros_like(tensor);
  for (const char* last : {"fc.weight", "fc.bias"})
    if (const auto found = weights.find(last);
        found == weights.end() || found->second.sizes() != own[last].sizes())
      weights[last] = own[last].detach().clone();
  set_weights(network, weights, file);
}

}  // namespace cps
