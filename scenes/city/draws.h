#pragma once

#include <algorithm>
#include <vector>

#include "random/counter_hash.h"
#include "scenes/city/city_options.h"

namespace cps::city {

/// The stream `name` for things that move: depends on the city's seed and on its traffic seed.
inline Stream moving_stream(const CityOptions& options, std::string_view name) {
  return substream(make_stream(options.seed, name), options.traffic_seed);
}

/// A sequence of random numbers for one thing of the city (a street, a building, a tree), from a stream of
/// its own, so that additional draws here never change another thing.
struct Draws {
  Stream stream;
  std::uint64_t next = 0;

  double uniform(double low, double high) { return random_uniform(stream, next++, low, high); }
  bool chance(double probability) { return random_uniform(stream, next++) < probability; }
  /// An integer in [low, high], both included.
  int integer(int low, int high) {
    return low + static_cast<int>(random_below(stream, next++, high - low + 1));
  }
  template <typename T>
  const T& one_of(const std::vector<T>& items) {
    return items[random_below(stream, next++, items.size())];
  }
};

}  // namespace cps::city
