#pragma once

#include <torch/types.h>

#include <filesystem>
#include <map>
#include <string>

namespace cps {

using NamedTensors = std::map<std::string, torch::Tensor>;

/// Writes a dictionary of tensors as Python's `torch.load` reads it, by atomic rename.
void save_tensors(const NamedTensors& tensors, const std::filesystem::path& file);

/// Reads one back. Throws std::runtime_error with one line when the file is missing or is no such dictionary.
NamedTensors load_tensors(const std::filesystem::path& file);

}  // namespace cps
