#include "tests/trainer/onnx/onnx_interpreter.h"

#include <ATen/ATen.h>

#include <cstring>
#include <stdexcept>

namespace cps {
namespace {

using torch::Tensor;
using Values = std::map<std::string, Tensor>;

/// A node whose attributes are taken one by one, so that none is overlooked.
struct Operator {
  const ReadNode& node;
  std::map<std::string, ReadAttribute> left;
  std::vector<Tensor> inputs;

  /// `type`: a number of AttributeProto.AttributeType.
  ReadAttribute take(const std::string& name, int type) {
    const ReadAttribute attribute = left.at(name);
    if (attribute.type != type) throw std::runtime_error(name + ": is of another type");
    left.erase(name);
    return attribute;
  }
  std::int64_t take_integer(const std::string& name) { return take(name, 2).integer; }
  std::vector<std::int64_t> take_integers(const std::string& name) { return take(name, 7).integers; }
  /// Pads of both axes, which must be the same on both sides.
  std::vector<std::int64_t> take_pads() {
    const std::vector<std::int64_t> pads =
        left.contains("pads") ? take_integers("pads") : std::vector<std::int64_t>(4);
    if (pads.size() != 4 || pads[0] != pads[2] || pads[1] != pads[3]) throw std::runtime_error("uneven pads");
    return {pads[0], pads[1]};
  }
  std::vector<std::int64_t> take_strides() {
    return left.contains("strides") ? take_integers("strides") : std::vector<std::int64_t>{1, 1};
  }
  std::vector<std::int64_t> input_integers(std::size_t i) const {
    const Tensor numbers = inputs.at(i).to(torch::kLong).contiguous();
    const std::int64_t* first = numbers.data_ptr<std::int64_t>();
    return {first, first + numbers.numel()};
  }

  Tensor convolution() {
    if (take_integers("kernel_shape") != inputs[1].sizes().slice(2).vec())
      throw std::runtime_error("kernel_shape is not the kernel's");
    const auto pads = take_pads(), strides = take_strides();
    return at::conv2d(inputs[0], inputs[1], {}, strides, pads);
  }
  Tensor pool() {
    const auto kernel = take_integers("kernel_shape"), pads = take_pads(), strides = take_strides();
    return at::max_pool2d(inputs[0], kernel, strides, pads);
  }
  /// Repeats the outermost pixels.
  Tensor pad() {
    const std::vector<std::int64_t> pads = input_integers(1);
    if (take("mode", 3).text != "edge" || pads.size() != 8 || pads[0] + pads[1] + pads[4] + pads[5] != 0)
      throw std::runtime_error("unknown pads");
    return at::replication_pad2d(inputs[0], {pads[3], pads[7], pads[2], pads[6]});
  }
  Tensor batch_norm() {
    return at::batch_norm(inputs[0], inputs[1], inputs[2], inputs[3], inputs[4], false, 0,
                          take("epsilon", 1).real, false);
  }
  Tensor linear() {
    const Tensor weights = take_integer("transB") ? inputs[1].t() : inputs[1];
    return at::matmul(inputs[0], weights) + inputs[2];
  }

  Tensor run() {
    const std::string& op = node.op;
    if (op == "Conv") return convolution();
    if (op == "MaxPool") return pool();
    if (op == "Pad") return pad();
    if (op == "BatchNormalization") return batch_norm();
    if (op == "Gemm") return linear();
    if (op == "Relu") return at::relu(inputs[0]);
    if (op == "Add") return inputs[0] + inputs[1];
    if (op == "Sub") return inputs[0] - inputs[1];
    if (op == "Mul") return inputs[0] * inputs[1];
    if (op == "Div") return inputs[0] / inputs[1];
    if (op == "Sqrt") return at::sqrt(inputs[0]);
    if (op == "Tan") return at::tan(inputs[0]);
    if (op == "Concat") return at::cat(inputs, take_integer("axis"));
    if (op == "Flatten") return inputs[0].flatten(take_integer("axis"));
    if (op == "GlobalAveragePool") return inputs[0].mean({2, 3}, true);
    if (op == "ReduceSum") return inputs[0].sum(input_integers(1), take_integer("keepdims") != 0);
    if (op == "Gather") return inputs[0].select(take_integer("axis"), inputs[1].item<std::int64_t>());
    throw std::runtime_error("unknown operator " + op);
  }
};

}  // namespace

Tensor to_torch(const ReadTensor& tensor) {
  if (tensor.type != 1 && tensor.type != 7) throw std::runtime_error("unknown type");
  const Tensor values = torch::empty(tensor.shape, tensor.type == 1 ? torch::kFloat : torch::kLong);
  if (values.nbytes() != tensor.bytes.size()) throw std::runtime_error("not as long as its shape says");
  std::memcpy(values.data_ptr(), tensor.bytes.data(), tensor.bytes.size());
  return values;
}

Values run_onnx(const ReadModel& model, const Values& inputs) {
  const torch::NoGradGuard no_gradients;
  Values values = inputs;
  for (const auto& [name, constant] : model.constants)
    if (!values.emplace(name, to_torch(constant)).second) throw std::runtime_error("two values " + name);
  for (const ReadNode& node : model.nodes) {
    Operator operation{node, node.attributes, {}};
    for (const std::string& input : node.inputs) {
      if (!values.contains(input)) throw std::runtime_error(node.name + ": " + input + " is not there yet");
      operation.inputs.push_back(values.at(input));
    }
    const Tensor result = operation.run();
    if (!operation.left.empty())
      throw std::runtime_error(node.name + ": unknown attribute " + operation.left.begin()->first);
    if (node.outputs.size() != 1 || !values.emplace(node.outputs[0], result).second)
      throw std::runtime_error(node.name + ": must have one output of its own");
  }
  Values outputs;
  for (const ReadValue& output : model.outputs) outputs[output.name] = values.at(output.name);
  return outputs;
}

}  // namespace cps
