#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// A network in the terms of ONNX (onnx.ai, "Open Neural Network Exchange", IR specification).
namespace cps {

struct OnnxAttribute {
  std::string name;
  std::variant<std::int64_t, float, std::string, std::vector<std::int64_t>> value;
};

/// An operator of the default domain. It has the name of its only output.
struct OnnxNode {
  std::string op;
  std::vector<std::string> inputs;
  std::string output;
  std::vector<OnnxAttribute> attributes;
};

using OnnxNumbers = std::variant<std::vector<float>, std::vector<std::int64_t>>;

/// A constant, in row-major order.
struct OnnxTensor {
  std::string name;
  std::vector<std::int64_t> shape;  ///< empty: a scalar
  OnnxNumbers numbers;
};

/// An input or output of the whole graph, of 32-bit floats.
struct OnnxValue {
  std::string name, description;
  std::vector<std::variant<std::int64_t, std::string>> shape;  ///< a number, or the name of one left open
};

struct OnnxGraph {
  std::string name;
  std::vector<OnnxNode> nodes;  ///< each after those whose outputs it uses
  std::vector<OnnxTensor> constants;
  std::vector<OnnxValue> inputs, outputs;
};

struct OnnxModel {
  std::string producer, producer_version, description;
  OnnxGraph graph;
  std::vector<std::pair<std::string, std::string>> metadata;  ///< names and texts
};

/// Adds a node. Returns `output`, the name of its result.
std::string add_node(OnnxGraph& graph, const std::string& op, std::vector<std::string> inputs,
                     const std::string& output, std::vector<OnnxAttribute> attributes = {});

/// Adds a constant. Returns `name`.
std::string add_constant(OnnxGraph& graph, const std::string& name, std::vector<std::int64_t> shape,
                         OnnxNumbers numbers);

/// Adds a scalar constant, a 32-bit float. Returns `name`.
std::string add_scalar(OnnxGraph& graph, const std::string& name, double value);

}  // namespace cps
