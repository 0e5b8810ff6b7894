#include <catch2/catch.hpp>
#include <map>
#include <numeric>
#include <vector>

#include "random/shuffle.h"

using namespace cps;

namespace {

using Order = std::vector<int>;

Order in_order(int count) {
  Order order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

Order shuffle_of(int count, Stream stream) {
  Order order = in_order(count);
  shuffle(order, stream);
  return order;
}

Order front_of(int count, int drawn, Stream stream) {
  Order order = in_order(count);
  draw_to_front(order, drawn, stream);
  return order;
}

Order shuffled_order_of(int count, Stream stream) {
  const auto order = shuffled_order(count, stream);
  return {order.begin(), order.end()};
}

constexpr int shuffles = 24'000;

/// χ² of how often each outcome of `draw(stream)` came up, if all `outcomes` are equally likely.
template <typename Draw>
double chi_square(int outcomes, Draw draw) {
  std::map<Order, int> counts;
  for (int i = 0; i < shuffles; ++i) ++counts[draw(substream(make_stream(5, "uniformity"), i))];
  REQUIRE(static_cast<int>(counts.size()) == outcomes);
  const double expected = static_cast<double>(shuffles) / outcomes;
  double sum = 0;
  for (const auto& [order, count] : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

}  // namespace

TEST_CASE("a shuffle holds each item once") {
  for (int count : {0, 1, 2, 3, 17, 1000}) {
    const Stream stream = make_stream(count, "order");
    for (Order order : {shuffle_of(count, stream), front_of(count, count / 2, stream),
                        front_of(count, count, stream), shuffled_order_of(count, stream)}) {
      std::ranges::sort(order);
      CHECK(order == in_order(count));
    }
  }
}

TEST_CASE("every order is equally likely") {
  // χ²(23) and χ²(11), p = 0.001.
  CHECK(chi_square(24, [](Stream stream) { return shuffle_of(4, stream); }) < 49.73);
  CHECK(chi_square(24, [](Stream stream) { return shuffled_order_of(4, stream); }) < 49.73);
  CHECK(chi_square(12, [](Stream stream) {
          Order front = front_of(4, 2, stream);
          front.resize(2);
          return front;
        }) < 31.26);
}

TEST_CASE("a longer shuffled order keeps the order of what it had") {
  const Stream stream = make_stream(11, "order");
  Order longer = shuffled_order_of(100, stream);
  std::erase_if(longer, [](int i) { return i >= 60; });
  CHECK(longer == shuffled_order_of(60, stream));
}

// Datasets and networks made earlier must come out again: these orders may only change together with the
// dataset's schema.
TEST_CASE("the random orders never change") {
  const Stream stream = make_stream(3, "order");
  CHECK(shuffle_of(10, stream) == Order{4, 0, 5, 7, 1, 9, 3, 2, 6, 8});
  CHECK(shuffled_order_of(10, stream) == Order{4, 1, 7, 0, 6, 3, 5, 8, 9, 2});
  CHECK(front_of(10, 5, stream) == Order{5, 4, 9, 7, 0, 1, 6, 3, 8, 2});
  Order later = in_order(10);
  shuffle(later, stream, 1);
  CHECK(later == Order{4, 9, 1, 0, 5, 3, 2, 6, 7, 8});
}
