#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Reads .onnx files, by the field numbers of onnx.proto alone; shares no code with the writer.
namespace cps {

struct ReadAttribute {
  int type = 0;
  std::int64_t integer = 0;
  float real = 0;
  std::string text;
  std::vector<std::int64_t> integers;
};

struct ReadNode {
  std::string op, name;
  std::vector<std::string> inputs, outputs;
  std::map<std::string, ReadAttribute> attributes;
};

struct ReadTensor {
  std::vector<std::int64_t> shape;
  int type = 0;
  std::string bytes;
};

struct ReadValue {
  std::string name, description;
  int type = 0;
  std::vector<std::string> shape;
};

struct ReadModel {
  std::int64_t ir_version = 0, operator_set = 0;
  std::string producer, producer_version, description, domain, graph_name;
  std::vector<ReadNode> nodes;
  std::map<std::string, ReadTensor> constants;
  std::vector<ReadValue> inputs, outputs;
  std::map<std::string, std::string> metadata;
};

/// Throws std::runtime_error on anything that is not such a message, unknown fields and repeated names among
/// it.
ReadModel read_onnx(std::string_view bytes);

}  // namespace cps
