#pragma once

#include <string>
#include <vector>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// `value` if it lies in [0, largest]; else the nearest that does, with a warning.
float factor(Document& document, double value, double largest, const std::string& where);

/// The numbers in extension property `key` (an array of `size`, or one number for size 1), or `missing`.
std::vector<double> extension_numbers(const Document& document, const tinygltf::Value& extension,
                                      const char* key, std::vector<double> missing, const std::string& where);

}  // namespace cps::gltf
