#include "dataset/exchange/formats/formats.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace cps {
namespace {

/// The beginning of the value as JSON, whatever bytes are in it.
std::string printable(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).substr(0, 40);
}

[[noreturn]] void refuse_number(const nlohmann::json& value, const std::string& where) {
  if (!value.is_string()) throw std::runtime_error(where + ": must be numbers, not " + printable(value));
  const std::string text = value.get<std::string>().substr(0, 40);
  std::string hint;
  if (text.find(',') != std::string::npos) hint = ": write the decimal point as a point";
  if (text.find(' ') != std::string::npos) hint = ": separate the numbers by commas";
  throw std::runtime_error(where + ": '" + text + "' is not a number" + hint);
}

void append_numbers(const nlohmann::json& list, const std::string& where, std::vector<double>& values) {
  for (const nlohmann::json& value : list) {
    if (value.is_array())
      append_numbers(value, where, values);
    else if (value.is_number())
      values.push_back(value.get<double>());
    else
      refuse_number(value, where);
  }
}

}  // namespace

void add_camera(ModelCalibrationFile& file, const std::string& name,
                const std::function<ModelCamera()>& read) {
  try {
    file.cameras.push_back(read());
  } catch (const std::runtime_error& error) {
    file.unread.push_back({name, error.what()});
  }
}

std::vector<double> number_list(const nlohmann::json& list, const std::string& where) {
  if (!list.is_array()) throw std::runtime_error(where + ": must be a list of numbers");
  std::vector<double> values;
  append_numbers(list, where, values);
  return values;
}

std::vector<double> number_list(const nlohmann::json& list, std::size_t count, const std::string& where) {
  std::vector<double> values = number_list(list, where);
  if (values.size() != count)
    throw std::runtime_error(where + ": must be " + std::to_string(count) + " numbers, not " +
                             std::to_string(values.size()));
  return values;
}

int size_px(double value, const std::string& where) {
  if (!(value >= 1 && value <= 1 << 20 && value == std::floor(value)))
    throw std::runtime_error(where + ": must be a size in whole pixels");
  return static_cast<int>(value);
}

std::string name_at(const JsonKeys& keys, const std::string& key) {
  const nlohmann::json& value = keys.at(key);
  return value.is_number() ? value.dump() : keys.text(key);
}

Pinhole pinhole_from_k(std::span<const double> k, int width, int height, const std::string& where) {
  if (k.size() != 9) throw std::runtime_error(where + ": must be 9 numbers, row by row");
  if (k[1] != 0) throw std::runtime_error(where + ": has skew, which is not supported");
  if (k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
    throw std::runtime_error(where + ": must be fx 0 cx, 0 fy cy, 0 0 1");
  return {.width = width, .height = height, .fx = k[0], .fy = k[4], .cx = k[2], .cy = k[5]};
}

std::string decimal(double value) {
  return nlohmann::json(value).dump();
}

std::string decimals(std::span<const double> values, const std::string& separator) {
  std::string text;
  for (double value : values) text += (text.empty() ? "" : separator) + decimal(value);
  return text;
}

std::vector<double> k_matrix(const Pinhole& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

const ModelCamera& only_camera(CameraSpan cameras) {
  if (cameras.size() != 1)
    throw std::runtime_error("this format holds one camera, not " + std::to_string(cameras.size()) +
                             ": choose one");
  return cameras.front();
}

}  // namespace cps
