#pragma once

#include <torch/types.h>

#include <map>
#include <string>

#include "tests/trainer/onnx/onnx_reader.h"

namespace cps {

/// Computes a graph, operator by operator as ONNX defines them (operator set 17), with LibTorch's functions.
/// Returns its outputs by name. Throws std::runtime_error on an operator or attribute that it does not know,
/// and on a value that is used before it is computed.
std::map<std::string, torch::Tensor> run_onnx(const ReadModel& model,
                                              const std::map<std::string, torch::Tensor>& inputs);

/// A constant of the graph. Its numbers are copied.
torch::Tensor to_torch(const ReadTensor& tensor);

}  // namespace cps
