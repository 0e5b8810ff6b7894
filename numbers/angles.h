#pragma once

#include <numbers>

/// Angles are radians in the code and degrees in options and files.
namespace cps {

constexpr double degrees(double radians) {
  return radians * (180 / std::numbers::pi);
}

constexpr double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}

}  // namespace cps
