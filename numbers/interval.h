#pragma once

namespace cps {

/// A closed interval of numbers.
struct Interval {
  double low = 0, high = 0;
  bool operator==(const Interval&) const = default;
};

}  // namespace cps
