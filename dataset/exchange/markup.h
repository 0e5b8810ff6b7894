#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// YAML and OpenCV's XML as JSON, so that one set of checks serves all.
namespace cps {

/// A YAML document; OpenCV's `%YAML:1.0` first line is tolerated. Scalars that read as numbers become
/// numbers, the others text. Throws std::runtime_error naming file and line.
nlohmann::json json_from_yaml(const std::string& text, const std::string& file);

/// The children of <opencv_storage>: matrices as {rows, cols, data}, as in OpenCV's YAML. Throws
/// std::runtime_error naming the file.
nlohmann::json json_from_opencv_xml(const std::string& text, const std::string& file);

/// A number where the text is one, whatever the locale, otherwise the text itself.
nlohmann::json scalar(const std::string& text);

}  // namespace cps
