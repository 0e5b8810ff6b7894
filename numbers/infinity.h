#pragma once

#include <limits>

namespace cps {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace cps
