#pragma once

#include <stdexcept>
#include <string>

namespace cps {

/// How the light in a view's render is found.
enum class LightMethod {
  traced,  ///< paths follow all of it
  cached   ///< that of sky, lamps' reflections and other surfaces is kept in cells of the scene
};

inline std::string to_string(LightMethod method) {
  return method == LightMethod::cached ? "cached" : "traced";
}

/// Throws std::runtime_error naming the methods there are.
inline LightMethod light_method_from(const std::string& name) {
  if (name == "traced") return LightMethod::traced;
  if (name == "cached") return LightMethod::cached;
  throw std::runtime_error("must be traced or cached");
}

}  // namespace cps
