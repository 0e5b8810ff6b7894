#pragma once

#include <type_traits>

namespace cps {

/// Calls function(channels) with the number of channels, 1–4, as a constant of the compiler's.
template <typename Function>
void with_channel_count(int channels, const Function& function) {
  switch (channels) {
    case 1:
      return function(std::integral_constant<int, 1>());
    case 2:
      return function(std::integral_constant<int, 2>());
    case 3:
      return function(std::integral_constant<int, 3>());
    default:
      return function(std::integral_constant<int, 4>());
  }
}

}  // namespace cps
