#pragma once

#include <string>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// `value` clamped to [0, max], with a warning if that changed it. Refuses a value that is not finite.
float factor(Document& document, double value, double max, const std::string& where);

/// The number or array of numbers in property `key` of an extension; `missing` if the property is absent.
/// Refuses another count of numbers than `missing` has.
std::vector<double> extension_numbers(const Document& document, const tinygltf::Value& extension,
                                      const char* key, std::vector<double> missing, const std::string& where);

}  // namespace cps::gltf
