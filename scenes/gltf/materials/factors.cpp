#include "scenes/gltf/materials/factors.h"

#include <algorithm>
#include <cmath>

namespace cps::gltf {

float factor(Document& document, double value, double max, const std::string& where) {
  if (!std::isfinite(value)) refuse(document, where, "is not a finite number");
  const double clamped = std::clamp(value, 0.0, max);
  if (clamped != value) warn(document, where + " is out of range, taken as " + std::to_string(clamped));
  return static_cast<float>(clamped);
}

std::vector<double> extension_numbers(const Document& document, const tinygltf::Value& extension,
                                      const char* key, std::vector<double> missing,
                                      const std::string& where) {
  if (!extension.IsObject() || !extension.Has(key)) return missing;
  const tinygltf::Value& value = extension.Get(key);
  std::vector<double> numbers;
  if (value.IsNumber()) numbers.push_back(value.GetNumberAsDouble());
  for (std::size_t i = 0; i < value.ArrayLen(); ++i)
    if (value.Get(static_cast<int>(i)).IsNumber())
      numbers.push_back(value.Get(static_cast<int>(i)).GetNumberAsDouble());
  bool finite = numbers.size() == missing.size();
  for (const double number : numbers) finite = finite && std::isfinite(number);
  if (!finite)
    refuse(document, where + "." + key, "must be " + std::to_string(missing.size()) + " finite number(s)");
  return numbers;
}

}  // namespace cps::gltf
