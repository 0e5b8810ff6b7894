#include "trainer/tensor_file.h"

#include <torch/csrc/jit/serialization/pickle.h>

#include <stdexcept>

#include "dataset/files.h"

namespace cps {

void save_tensors(const NamedTensors& tensors, const std::filesystem::path& file) {
  c10::Dict<std::string, torch::Tensor> dictionary;
  for (const auto& [name, tensor] : tensors) dictionary.insert(name, tensor.detach().contiguous().cpu());
  const std::vector<char> bytes = torch::jit::pickle_save(dictionary);
  write_file(file, bytes);
}

NamedTensors load_tensors(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::vector<char> bytes(text.begin(), text.end());
  NamedTensors tensors;
  try {
    for (const auto& entry : torch::jit::pickle_load(bytes).toGenericDict())
      tensors[entry.key().toStringRef()] = entry.value().toTensor();
  } catch (const std::exception&) {
    throw std::runtime_error(file.string() +
                             ": is damaged or no dictionary of tensors: train again or restore it");
  }
  return tensors;
}

}  // namespace cps
