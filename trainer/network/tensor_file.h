#pragma once

#include <torch/types.h>

#include <filesystem>
#include <map>
#include <string>

namespace cps {

using NamedTensors = std::map<std::string, torch::Tensor>;

/// Writes a dictionary of tensors as Python's torch.save does: torch.load reads it, with weights_only=True,
/// too. By atomic rename; the same tensors make the same bytes. Kinds of numbers: float, double, 64-bit and
/// 8-bit integers.
void save_tensors(const NamedTensors& tensors, const std::filesystem::path& file);

/// Reads what save_tensors() or Python's torch.save (since PyTorch 1.6) wrote of a dictionary of tensors: a
/// state_dict() as it is, torchvision's files among them. Nothing in the file is run. Entries that are no
/// tensors are left out. Throws std::runtime_error with one line when the file is missing or is no such
/// dictionary.
NamedTensors load_tensors(const std::filesystem::path& file);

}  // namespace cps
