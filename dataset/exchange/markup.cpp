#include "dataset/exchange/markup.h"

#include <yaml-cpp/yaml.h>

#include <charconv>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

namespace cps {
namespace {

constexpr int deepest = 32;

nlohmann::json from_node(const YAML::Node& node, int depth) {
  if (depth > deepest) throw std::runtime_error("is nested too deeply");
  nlohmann::json json;
  constexpr const char* quoted = "!";  // yaml-cpp: "02" in quotes is text
  if (node.IsScalar()) return node.Tag() == quoted ? nlohmann::json(node.Scalar()) : scalar(node.Scalar());
  if (node.IsSequence()) {
    json = nlohmann::json::array();
    for (const YAML::Node& item : node) json.push_back(from_node(item, depth + 1));
  }
  if (node.IsMap()) {
    json = nlohmann::json::object();
    for (const auto& item : node) json[item.first.Scalar()] = from_node(item.second, depth + 1);
  }
  return json;
}

}  // namespace

nlohmann::json scalar(const std::string& text) {
  const char *begin = text.data(), *end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  std::uint64_t whole = 0;
  if (const auto [rest, error] = std::from_chars(begin, end, whole); error == std::errc() && rest == end)
    return whole;
  double value = 0;
  if (const auto [rest, error] = std::from_chars(begin, end, value); error == std::errc() && rest == end)
    return value;
  return text;
}

nlohmann::json json_from_yaml(const std::string& text, const std::string& file) try {
  const bool has_directive = text.starts_with("%YAML");
  return from_node(YAML::Load(has_directive ? text.substr(std::min(text.find('\n'), text.size())) : text), 0);
} catch (const YAML::Exception& error) {
  throw std::runtime_error(file + ": line " + std::to_string(error.mark.line + 1) +
                           ": is not YAML: " + error.msg);
}

nlohmann::json json_from_opencv_xml(const std::string& text, const std::string& file) {
  pugi::xml_document document;
  if (const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size()); !result)
    throw std::runtime_error(file + ": is not XML: " + result.description());
  nlohmann::json json = nlohmann::json::object();
  for (const pugi::xml_node& node : document.child("opencv_storage").children()) {
    if (!node.child("data")) {
      json[node.name()] = scalar(node.text().get());
      continue;
    }
    nlohmann::json& matrix = json[node.name()];
    for (const char* key : {"rows", "cols"}) matrix[key] = scalar(node.child(key).text().get());
    matrix["data"] = nlohmann::json::array();
    std::istringstream words(node.child("data").text().get());
    for (std::string word; words >> word;) matrix["data"].push_back(scalar(word));
  }
  return json;
}

}  // namespace cps
