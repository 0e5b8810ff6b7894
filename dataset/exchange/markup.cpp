#include "dataset/exchange/markup.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace cps {
namespace {

constexpr int max_depth = 32;
/// Values after aliases are expanded: far more than any calibration, far less than memory.
constexpr int max_values = 200'000;

nlohmann::json from_node(const YAML::Node& node, int depth, int& values) {
  if (depth > max_depth) throw YAML::Exception(node.Mark(), "is nested too deeply");
  if (++values > max_values) throw YAML::Exception(node.Mark(), "expands to too many values");
  nlohmann::json json;
  constexpr const char* quoted = "!";  // yaml-cpp: "02" in quotes is text
  if (node.IsScalar()) return node.Tag() == quoted ? nlohmann::json(node.Scalar()) : scalar(node.Scalar());
  if (node.IsSequence()) {
    json = nlohmann::json::array();
    for (const YAML::Node& item : node) json.push_back(from_node(item, depth + 1, values));
  }
  if (node.IsMap()) {
    json = nlohmann::json::object();
    for (const auto& item : node) {
      if (!item.first.IsScalar()) throw YAML::Exception(item.first.Mark(), "a key must be a single word");
      const std::string key = item.first.Scalar();
      if (json.contains(key)) throw YAML::Exception(item.first.Mark(), "the key '" + key + "' appears twice");
      json[key] = from_node(item.second, depth + 1, values);
    }
  }
  return json;
}

nlohmann::json opencv_matrix(const pugi::xml_node& node) {
  nlohmann::json matrix;
  for (const char* key : {"rows", "cols"}) matrix[key] = scalar(node.child(key).text().get());
  matrix["data"] = nlohmann::json::array();
  std::istringstream words(node.child("data").text().get());
  for (std::string word; words >> word;) matrix["data"].push_back(scalar(word));
  return matrix;
}

}  // namespace

nlohmann::json scalar(const std::string& text) {
  const char *begin = text.data(), *end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  if (end - begin > 1 && begin[0] == '0' && std::isdigit(static_cast<unsigned char>(begin[1])) != 0)
    return text;
  std::uint64_t whole = 0;
  if (const auto [rest, error] = std::from_chars(begin, end, whole); error == std::errc() && rest == end)
    return whole;
  double value = 0;
  if (const auto [rest, error] = std::from_chars(begin, end, value); error == std::errc() && rest == end)
    return value;
  return text;
}

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

nlohmann::json json_from_json(const std::string& text, const std::string& file) try {
  std::vector<std::set<std::string>> open_objects;
  const auto refuse = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > max_depth) throw std::runtime_error(file + ": is nested too deeply");
    if (event == Event::object_start) open_objects.emplace_back();
    if (event == Event::object_end) open_objects.pop_back();
    if (event == Event::key && !open_objects.back().insert(parsed.get<std::string>()).second)
      throw std::runtime_error(file + ": " + parsed.get<std::string>() + ": appears twice: keep one");
    return true;
  };
  return nlohmann::json::parse(text, refuse);
} catch (const nlohmann::json::exception& error) {
  throw std::runtime_error(file + ": is not JSON: " + error.what());
}

nlohmann::json json_from_yaml(const std::string& text, const std::string& file) try {
  const bool has_directive = text.starts_with("%YAML");
  int values = 0;
  return from_node(YAML::Load(has_directive ? text.substr(std::min(text.find('\n'), text.size())) : text), 0,
                   values);
} catch (const YAML::ParserException& error) {
  throw std::runtime_error(file + ": line " + std::to_string(error.mark.line + 1) +
                           ": is not YAML: " + error.msg);
} catch (const YAML::Exception& error) {
  throw std::runtime_error(file + ": line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
}

nlohmann::json json_from_xml(const std::string& text, const std::string& file) {
  pugi::xml_document document;
  if (const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size()); !result)
    throw std::runtime_error(file + ": is not XML: " + result.description());
  nlohmann::json json = nlohmann::json::object();
  const pugi::xml_node storage = document.child("opencv_storage");
  for (const pugi::xml_node& node : (storage ? storage : document.child("calibration")).children()) {
    if (node.type() != pugi::node_element) continue;
    if (json.contains(node.name()))
      throw std::runtime_error(file + ": " + node.name() + ": appears twice: keep one");
    json[node.name()] = node.child("data") ? opencv_matrix(node) : scalar(node.text().get());
  }
  return json;
}

}  // namespace cps
