#include "tests/trainer/onnx/onnx_reader.h"

#include <cstring>
#include <functional>
#include <stdexcept>

namespace cps {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("not an ONNX file: " + what);
}

/// One field of a message.
struct Field {
  int number = 0;
  std::uint64_t integer = 0;    ///< of a varint
  float real = 0;               ///< of 32 bits
  std::string_view bytes = {};  ///< of a length-delimited field
};

/// The fields of a message, one after another.
struct Fields {
  std::string_view rest;

  std::string_view take(std::size_t count) {
    if (rest.size() < count) fail("cut short");
    const std::string_view taken = rest.substr(0, count);
    rest.remove_prefix(count);
    return taken;
  }
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = static_cast<unsigned char>(take(1)[0]);
      value |= std::uint64_t{byte & 0x7fu} << shift;
      if (byte < 0x80) return value;
    }
    fail("a number of more than 64 bits");
  }
  Field next() {
    const std::uint64_t tag = varint(), type = tag & 7;
    Field field{.number = static_cast<int>(tag >> 3)};
    if (type == 0)
      field.integer = varint();
    else if (type == 2)
      field.bytes = take(varint());
    else if (type == 5)
      std::memcpy(&field.real, take(4).data(), 4);
    else
      fail("wire type " + std::to_string(type));
    return field;
  }
};

using Read = std::function<void(const Field&)>;

/// Reads a message by what is to be done with the field of each number.
void read_message(const char* type, std::string_view message, const std::map<int, Read>& reads) {
  for (Fields fields{message}; !fields.rest.empty();) {
    const Field field = fields.next();
    if (!reads.contains(field.number))
      fail(std::string(type) + " with a field " + std::to_string(field.number));
    reads.at(field.number)(field);
  }
}

template <typename Number>
Read number(Number& into) {
  return [&](const Field& field) { into = static_cast<Number>(field.integer); };
}
Read text(std::string& into) {
  return [&](const Field& field) { into = field.bytes; };
}
Read texts(std::vector<std::string>& into) {
  return [&](const Field& field) { into.emplace_back(field.bytes); };
}
Read numbers(std::vector<std::int64_t>& into) {
  return [&](const Field& field) { into.push_back(static_cast<std::int64_t>(field.integer)); };
}

template <typename T>
void insert(std::map<std::string, T>& into, const std::string& name, T value) {
  if (!into.emplace(name, std::move(value)).second) fail("two of the name " + name);
}

void read_attribute(std::string_view message, ReadNode& node) {
  std::string name;
  ReadAttribute attribute;
  read_message("AttributeProto", message,
               {{1, text(name)},
                {2, [&](const Field& field) { attribute.real = field.real; }},
                {3, number(attribute.integer)},
                {4, text(attribute.text)},
                {8, numbers(attribute.integers)},
                {20, number(attribute.type)}});
  insert(node.attributes, name, attribute);
}

ReadNode read_node(std::string_view message) {
  ReadNode node;
  read_message("NodeProto", message,
               {{1, texts(node.inputs)},
                {2, texts(node.outputs)},
                {3, text(node.name)},
                {4, text(node.op)},
                {5, [&](const Field& field) { read_attribute(field.bytes, node); }}});
  return node;
}

void read_tensor(std::string_view message, ReadModel& model) {
  std::string name;
  ReadTensor tensor;
  read_message(
      "TensorProto", message,
      {{1, numbers(tensor.shape)}, {2, number(tensor.type)}, {8, text(name)}, {9, text(tensor.bytes)}});
  insert(model.constants, name, tensor);
}

/// The number of a dimension, or its name.
std::string read_dimension(std::string_view message) {
  std::string side;
  read_message("Dimension", message,
               {{1, [&](const Field& field) { side = std::to_string(field.integer); }}, {2, text(side)}});
  return side;
}

void read_shape(std::string_view message, ReadValue& value) {
  read_message("TensorShapeProto", message,
               {{1, [&](const Field& field) { value.shape.push_back(read_dimension(field.bytes)); }}});
}

void read_tensor_type(std::string_view message, ReadValue& value) {
  read_message("TypeProto.Tensor", message,
               {{1, number(value.type)}, {2, [&](const Field& field) { read_shape(field.bytes, value); }}});
}

void read_type(std::string_view message, ReadValue& value) {
  read_message("TypeProto", message,
               {{1, [&](const Field& field) { read_tensor_type(field.bytes, value); }}});
}

ReadValue read_value(std::string_view message) {
  ReadValue value;
  read_message("ValueInfoProto", message,
               {{1, text(value.name)},
                {2, [&](const Field& field) { read_type(field.bytes, value); }},
                {3, text(value.description)}});
  return value;
}

void read_graph(std::string_view message, ReadModel& model) {
  read_message("GraphProto", message,
               {{1, [&](const Field& field) { model.nodes.push_back(read_node(field.bytes)); }},
                {2, text(model.graph_name)},
                {5, [&](const Field& field) { read_tensor(field.bytes, model); }},
                {11, [&](const Field& field) { model.inputs.push_back(read_value(field.bytes)); }},
                {12, [&](const Field& field) { model.outputs.push_back(read_value(field.bytes)); }}});
}

void read_metadata(std::string_view message, ReadModel& model) {
  std::string key, value;
  read_message("StringStringEntryProto", message, {{1, text(key)}, {2, text(value)}});
  insert(model.metadata, key, value);
}

}  // namespace

ReadModel read_onnx(std::string_view bytes) {
  ReadModel model;
  read_message("ModelProto", bytes,
               {{1, number(model.ir_version)},
                {2, text(model.producer)},
                {3, text(model.producer_version)},
                {6, text(model.description)},
                {7, [&](const Field& field) { read_graph(field.bytes, model); }},
                {8,
                 [&](const Field& field) {
                   read_message("OperatorSetIdProto", field.bytes,
                                {{1, text(model.domain)}, {2, number(model.operator_set)}});
                 }},
                {14, [&](const Field& field) { read_metadata(field.bytes, model); }}});
  return model;
}

}  // namespace cps
