#include "trainer/onnx/onnx_bytes.h"

#include <bit>
#include <string_view>

#include "trainer/onnx/protobuf.h"

namespace cps {
namespace {

// Numbers of fields and enumerators as in onnx.proto of ONNX 1.12, whose operator set is 17.
constexpr int ir_version = 8, operator_set = 17;
constexpr int float_type = 1, int64_type = 7;  // TensorProto.DataType
constexpr int attribute_float = 1, attribute_int = 2, attribute_string = 3,
              attribute_ints = 7;  // AttributeProto.AttributeType

static_assert(std::endian::native == std::endian::little, "raw_data is little-endian");

template <typename T>
std::string_view raw_bytes(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

std::string encoded(const OnnxAttribute& attribute) {  // AttributeProto
  std::string message;
  put_bytes_field(message, 1, attribute.name);
  int type = attribute_ints;
  if (const auto* real = std::get_if<float>(&attribute.value)) {
    put_float_field(message, 2, *real);
    type = attribute_float;
  } else if (const auto* integer = std::get_if<std::int64_t>(&attribute.value)) {
    put_integer_field(message, 3, *integer);
    type = attribute_int;
  } else if (const auto* text = std::get_if<std::string>(&attribute.value)) {
    put_bytes_field(message, 4, *text);
    type = attribute_string;
  } else {
    for (std::int64_t number : std::get<std::vector<std::int64_t>>(attribute.value))
      put_integer_field(message, 8, number);
  }
  put_integer_field(message, 20, type);
  return message;
}

std::string encoded(const OnnxNode& node) {  // NodeProto
  std::string message;
  for (const std::string& input : node.inputs) put_bytes_field(message, 1, input);
  put_bytes_field(message, 2, node.output);
  put_bytes_field(message, 3, node.output);
  put_bytes_field(message, 4, node.op);
  for (const OnnxAttribute& attribute : node.attributes) put_bytes_field(message, 5, encoded(attribute));
  return message;
}

std::string encoded(const OnnxTensor& tensor) {  // TensorProto
  std::string message;
  for (std::int64_t side : tensor.shape) put_integer_field(message, 1, side);
  const bool is_float = std::holds_alternative<std::vector<float>>(tensor.numbers);
  put_integer_field(message, 2, is_float ? float_type : int64_type);
  put_bytes_field(message, 8, tensor.name);
  std::visit([&](const auto& numbers) { put_bytes_field(message, 9, raw_bytes(numbers)); }, tensor.numbers);
  return message;
}

std::string encoded(const OnnxValue& value) {  // ValueInfoProto
  std::string shape, tensor_type, type, message;
  for (const auto& side : value.shape) {
    std::string dimension;
    if (const auto* number = std::get_if<std::int64_t>(&side)) put_integer_field(dimension, 1, *number);
    if (const auto* name = std::get_if<std::string>(&side)) put_bytes_field(dimension, 2, *name);
    put_bytes_field(shape, 1, dimension);
  }
  put_integer_field(tensor_type, 1, float_type);
  put_bytes_field(tensor_type, 2, shape);
  put_bytes_field(type, 1, tensor_type);
  put_bytes_field(message, 1, value.name);
  put_bytes_field(message, 2, type);
  put_bytes_field(message, 3, value.description);
  return message;
}

std::string encoded(const OnnxGraph& graph) {  // GraphProto
  std::string message;
  for (const OnnxNode& node : graph.nodes) put_bytes_field(message, 1, encoded(node));
  put_bytes_field(message, 2, graph.name);
  for (const OnnxTensor& tensor : graph.constants) put_bytes_field(message, 5, encoded(tensor));
  for (const OnnxValue& input : graph.inputs) put_bytes_field(message, 11, encoded(input));
  for (const OnnxValue& output : graph.outputs) put_bytes_field(message, 12, encoded(output));
  return message;
}

}  // namespace

std::string onnx_bytes(const OnnxModel& model) {  // ModelProto
  std::string message, operators;
  put_integer_field(message, 1, ir_version);
  put_bytes_field(message, 2, model.producer);
  put_bytes_field(message, 3, model.producer_version);
  put_bytes_field(message, 6, model.description);
  put_bytes_field(message, 7, encoded(model.graph));
  put_bytes_field(operators, 1, "");  // the default domain
  put_integer_field(operators, 2, operator_set);
  put_bytes_field(message, 8, operators);
  for (const auto& [name, text] : model.metadata) {
    std::string entry;
    put_bytes_field(entry, 1, name);
    put_bytes_field(entry, 2, text);
    put_bytes_field(message, 14, entry);
  }
  return message;
}

}  // namespace cps
