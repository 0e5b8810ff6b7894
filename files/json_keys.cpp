#include "files/json_keys.h"

#include <stdexcept>

namespace cps {

void JsonKeys::fail(const std::string& key, const std::string& what) const {
  throw std::runtime_error(file + ": " + key + ": " + what);
}

const nlohmann::json& JsonKeys::at(const std::string& key) const {
  if (!json.is_object() || !json.contains(key)) fail(key, "is missing");
  return json.at(key);
}

double JsonKeys::number(const std::string& key) const {
  if (!at(key).is_number()) fail(key, "must be a number");
  return at(key).get<double>();
}

std::uint64_t JsonKeys::unsigned_integer(const std::string& key) const {
  if (!at(key).is_number_unsigned()) fail(key, "must be a whole number that is not negative");
  return at(key).get<std::uint64_t>();
}

int JsonKeys::pixels(const std::string& key) const {
  const std::uint64_t value = unsigned_integer(key);
  if (value < 1 || value > 1 << 20) fail(key, "must be a size in pixels");
  return static_cast<int>(value);
}

std::string JsonKeys::text(const std::string& key) const {
  if (!at(key).is_string()) fail(key, "must be text");
  return at(key).get<std::string>();
}

JsonKeys JsonKeys::object(const std::string& key) const {
  return {at(key), file};
}

std::vector<double> JsonKeys::numbers(const std::string& key, std::size_t count) const {
  const nlohmann::json& list = at(key);
  bool is_right = list.is_array() && list.size() == count;
  std::vector<double> values;
  for (std::size_t i = 0; is_right && i < count; ++i) {
    is_right = list[i].is_number();
    if (is_right) values.push_back(list[i].get<double>());
  }
  if (!is_right) fail(key, "must be " + std::to_string(count) + " numbers");
  return values;
}

Eigen::MatrixXd JsonKeys::matrix(const std::string& key, int rows, int columns) const {
  const nlohmann::json& list = at(key);
  Eigen::MatrixXd result(rows, columns);
  bool is_right = list.is_array() && static_cast<int>(list.size()) == rows;
  for (int r = 0; is_right && r < rows; ++r) {
    is_right = list[r].is_array() && static_cast<int>(list[r].size()) == columns;
    for (int c = 0; is_right && c < columns; ++c) {
      is_right = list[r][c].is_number();
      if (is_right) result(r, c) = list[r][c].get<double>();
    }
  }
  if (!is_right)
    fail(key, "must be " + std::to_string(rows) + " rows of " + std::to_string(columns) + " numbers");
  return result;
}

}  // namespace cps
