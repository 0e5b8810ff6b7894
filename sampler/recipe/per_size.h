#pragma once

#include <cstddef>
#include <vector>

namespace cps {

/// One number for all sizes of a recipe, or one number per size.
struct PerSize {
  std::vector<int> values;

  PerSize(int all) : values{all} {}

  /// The number for the recipe's `size`-th size.
  int operator[](std::size_t size) const { return values.size() == 1 ? values[0] : values.at(size); }

  bool operator==(const PerSize&) const = default;
};

}  // namespace cps
