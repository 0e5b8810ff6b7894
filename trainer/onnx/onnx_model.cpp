#include "trainer/onnx/onnx_model.h"

namespace cps {

std::string add_node(OnnxGraph& graph, const std::string& op, std::vector<std::string> inputs,
                     const std::string& output, std::vector<OnnxAttribute> attributes) {
  graph.nodes.push_back({op, std::move(inputs), output, std::move(attributes)});
  return output;
}

std::string add_constant(OnnxGraph& graph, const std::string& name, std::vector<std::int64_t> shape,
                         OnnxNumbers numbers) {
  graph.constants.push_back({name, std::move(shape), std::move(numbers)});
  return name;
}

std::string add_scalar(OnnxGraph& graph, const std::string& name, double value) {
  return add_constant(graph, name, {}, std::vector{static_cast<float>(value)});
}

}  // namespace cps
