#pragma once

#include <filesystem>

#include "trainer/network/resnet.h"
#include "trainer/network/tensor_file.h"

/// A network's weights as named tensors, and back.
namespace cps {

/// Parameters and buffers under torchvision's names. The tensors share the network's memory.
NamedTensors weights_of(const Network& network);

/// The same for a file of half the size: parameters rounded to the nearest float16, to within 2^-11 of the
/// number, or 2^-25 where it is below 2^-14. Buffers stay as they are: a running variance may lie outside
/// float16's range and is divided by, and all of them together are a small part of a network. Throws
/// std::runtime_error that starts with `file`, where the network comes from, if a parameter is not finite or
/// would be infinite.
NamedTensors half_weights_of(const Network& network, const std::filesystem::path& file);

/// Copies `weights`, widened to the network's own element types, into the network. Throws std::runtime_error
/// that starts with `file`, where they come from, if a tensor is missing, left over, or of another shape.
void set_weights(Network& network, const NamedTensors& weights, const std::filesystem::path& file);

/// Copies weights that a network of this architecture learned on other data, for instance torchvision's on
/// ImageNet. A first layer for three colours is summed over them, which gives the same result on gray
/// pictures. Edge channels, orientation and edge weights that `weights` lack start at zero weight. A last
/// layer of another shape keeps the network's own weights. Throws std::runtime_error that starts with `file`
/// if another tensor is missing or of another shape.
void start_from(Network& network, NamedTensors weights, const std::filesystem::path& file);

}  // namespace cps
