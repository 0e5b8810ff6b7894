#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ranges>
#include <utility>
#include <vector>

#include "random/counter_hash.h"

/// Random orders, each a pure function of its stream. There are several algorithms because the order decides
/// the bytes of datasets and trained networks, so that a caller cannot change its algorithm. They also differ
/// when a list grows: `shuffle` and `draw_to_front` may give an altogether different order, `shuffled_order`
/// keeps the relative order of the earlier items.
namespace cps {

/// Shuffles `items` in place; every order is equally likely (Fisher–Yates; Durstenfeld 1964). The item at
/// position i is drawn with the number `first_number` + i of `stream`, for i from the last position down
/// to 1.
template <std::ranges::random_access_range Items>
void shuffle(Items& items, Stream stream, std::uint64_t first_number = 0) {
  for (std::size_t i = std::ranges::size(items); i-- > 1;)
    std::swap(items[i], items[random_below(stream, first_number + i, i + 1)]);
}

/// Moves `count` ≤ items.size() items, drawn without replacement, to the front of `items`: the first `count`
/// steps of a Fisher–Yates shuffle that starts at the front. For drawing a few of many.
template <std::ranges::random_access_range Items>
void draw_to_front(Items& items, std::size_t count, Stream stream) {
  for (std::size_t i = 0; i < count; ++i)
    std::swap(items[i], items[i + random_below(stream, i, std::ranges::size(items) - i)]);
}

/// 0 … count−1 in random order: sorted by a random key per number. A larger `count` inserts the new numbers
/// between the old ones and keeps the relative order of the old ones.
inline std::vector<std::size_t> shuffled_order(std::size_t count, Stream stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(random_bits(stream, i), i); });
  return order;
}

}  // namespace cps
