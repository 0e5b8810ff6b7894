#pragma once

#include <string>

namespace cps {

/// Why a camera position is rejected.
enum class PlaceFault {
  none,
  inside,     ///< a third of all directions around it show the back of a single-sided surface: it is inside
              ///< something or below the ground
  too_close,  ///< something other than ground is within 45° of its axis and nearer than allowed
  only_sky,   ///< more than three quarters of what lies within 45° of its axis is sky
  dark,       ///< less than a tenth of what lies within 45° of its axis is lit
  blown_out,  ///< more than a third of it would be white when the rest is exposed
};
inline constexpr int place_fault_count = 6;

/// The fault's name, for counts and tables.
std::string to_string(PlaceFault fault);

}  // namespace cps
