#pragma once

#include <utility>

namespace cps {

/// Replaces `at` by the first position with a lower cost along a step that is halved up to four times:
/// position_at(length), for the step's share `length`. Returns whether there is one. A position has a `cost`.
template <typename Position, typename PositionAt>
bool take_lower(Position& at, PositionAt position_at) {
  double length = 1;
  for (int halvings = 0; halvings < 5; ++halvings, length /= 2) {
    Position next = position_at(length);
    if (!(next.cost < at.cost)) continue;
    at = std::move(next);
    return true;
  }
  return false;
}

}  // namespace cps
