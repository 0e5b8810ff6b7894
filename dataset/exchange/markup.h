#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// Converts YAML and OpenCV's XML to JSON, so that one set of checks (JsonKeys) serves all formats. The
/// conversion is written by hand, on yaml-cpp and pugixml, because no library knows OpenCV's two dialects.
namespace cps {

/// A YAML document; OpenCV's first line `%YAML:1.0`, which is no valid YAML, is accepted. Scalars that read
/// as numbers become numbers, others text. Throws std::runtime_error naming file and line.
nlohmann::json json_from_yaml(const std::string& text, const std::string& file);

/// The children of <opencv_storage>: matrices as {rows, cols, data}, as in OpenCV's YAML. Throws
/// std::runtime_error naming the file.
nlohmann::json json_from_opencv_xml(const std::string& text, const std::string& file);

/// A number if the text is one (independent of the locale), otherwise the text itself.
nlohmann::json scalar(const std::string& text);

}  // namespace cps
