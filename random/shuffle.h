#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ranges>
#include <utility>
#include <vector>

#include "random/counter_hash.h"

/// Random orders, each a pure function of its stream. Which function a caller uses decides the bytes of a
/// dataset or of a trained network, so a caller stays with its function. They differ in what they promise
/// when a list grows: `shuffle` and `draw_to_front` may then give another order altogether, `shuffled_order`
/// keeps the order it had.
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
/// steps of a Fisher–Yates shuffle that runs from the front, for when few of many are wanted.
template <std::ranges::random_access_range Items>
void draw_to_front(Items& items, std::size_t count, Stream stream) {
  for (std::size_t i = 0; i < count; ++i)
    std::swap(items[i], items[i + random_below(stream, i, std::ranges::size(items) - i)]);
}

/// 0 … count−1 in random order: sorted by one random key each. A larger `count` puts the new numbers between
/// the old ones, whose order among each other stays.
inline std::vector<std::size_t> shuffled_order(std::size_t count, Stream stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(random_bits(stream, i), i); });
  return order;
}

}  // namespace cps
