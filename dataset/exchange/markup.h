#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// JSON, YAML and XML as JSON, so that one set of checks serves all. A key that appears twice is refused: one
/// of the two values would be dropped in silence.
namespace cps {

/// Throws std::runtime_error naming file and position.
nlohmann::json json_from_json(const std::string& text, const std::string& file);

/// A YAML document; OpenCV's `%YAML:1.0` first line is tolerated. Scalars that read as numbers become
/// numbers, the others text. Aliases are expanded up to a bounded size. Throws std::runtime_error naming file
/// and line.
nlohmann::json json_from_yaml(const std::string& text, const std::string& file);

/// The children of <opencv_storage>: matrices as {rows, cols, data}, as in OpenCV's YAML. Metashape's
/// <calibration>: its children. Throws std::runtime_error naming the file.
nlohmann::json json_from_xml(const std::string& text, const std::string& file);

/// A number where the text is one, whatever the locale, otherwise the text itself. Text with a leading zero
/// before another digit ("02") stays text: it is a name.
nlohmann::json scalar(const std::string& text);

/// The text with spaces for line breaks and other control characters: messages quote the file.
std::string one_line(std::string text);

}  // namespace cps
