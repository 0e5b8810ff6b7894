#pragma once

#include <torch/types.h>

#include <filesystem>
#include <map>
#include <string>

namespace cps {

using NamedTensors = std::map<std::string, torch::Tensor>;

/// Writes a dictionary of tensors in the format of Python's torch.save; torch.load reads it, also with
/// weights_only=True. By atomic rename. The same tensors give the same bytes. Element types: float, half,
/// double, 64-bit integer, unsigned 8-bit integer; throws std::runtime_error on another.
void save_tensors(const NamedTensors& tensors, const std::filesystem::path& file);

/// Reads a dictionary of tensors written by save_tensors() or by Python's torch.save (PyTorch 1.6 or newer),
/// for instance a state_dict() of torchvision. Executes nothing in the file. Skips entries that are not
/// tensors. Element types are those of the file. Throws std::runtime_error with one line if the file is
/// missing, damaged, holds no such dictionary, or an element type that save_tensors() does not know.
NamedTensors load_tensors(const std::filesystem::path& file);

}  // namespace cps
