#pragma once

#include <filesystem>

#include "trainer/network/resnet.h"
#include "trainer/network/tensor_file.h"

/// A network's weights as named tensors, and back.
namespace cps {

/// Parameters and buffers under torchvision's names. The tensors share the network's memory.
NamedTensors weights_of(const Network& network);

/// Copies `weights` into the network. Throws std::runtime_error that starts with `file`, where they come
/// from, if a tensor is missing, left over, or of another shape.
void set_weights(Network& network, const NamedTensors& weights, const std::filesystem::path& file);

/// Copies weights that a network of this architecture learned on other data, for instance torchvision's on
/// ImageNet. A first layer for three colours is summed over them, which gives the same result on gray
/// pictures. Edge channels and orientation that `weights` lack start at zero weight. A last layer of another
/// shape keeps the network's own weights. Throws std::runtime_error that starts with `file` if another tensor
/// is missing or of another shape.
void start_from(Network& network, NamedTensors weights, const std::filesystem::path& file);

}  // namespace cps
