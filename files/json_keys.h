#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cps {

/// Reads and checks the keys of a JSON object. Every function throws std::runtime_error with one line,
/// `<file>: <key>: <what is wrong>`, when the key is missing or its value is of another kind.
struct JsonKeys {
  const nlohmann::json& json;
  const std::string& file;  ///< for error messages

  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

  const nlohmann::json& at(const std::string& key) const;
  double number(const std::string& key) const;
  std::uint64_t unsigned_integer(const std::string& key) const;
  /// A whole number between 1 and 2²⁰.
  int pixels(const std::string& key) const;
  std::string text(const std::string& key) const;
  JsonKeys object(const std::string& key) const;
  /// A list of `count` numbers.
  std::vector<double> numbers(const std::string& key, std::size_t count) const;
  /// Nested lists, one per row.
  Eigen::MatrixXd matrix(const std::string& key, int rows, int columns) const;
};

}  // namespace cps
