#pragma once

#include <algorithm>
#include <vector>

#include "random/counter_hash.h"
#include "scenes/city/city_options.h"

namespace cps::city {

/// What of the city is elsewhere on another day draws from this: `name` of its seed and its traffic's.
inline Stream moving_stream(const CityOptions& options, std::string_view name) {
  return substream(make_stream(options.seed, name), options.traffic_seed);
}

/// What one thing of the city (a street, a building, a tree) draws, in order, from a stream of its own: more
/// draws here never shift another thing's.
struct Draws {
  Stream stream;
  std::uint64_t next = 0;

  double uniform(double low, double high) { return random_uniform(stream, next++, low, high); }
  bool chance(double probability) { return random_uniform(stream, next++) < probability; }
  /// A whole number in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(random_below(stream, next++, high - low + 1));
  }
  template <typename T>
  const T& one_of(const std::vector<T>& items) {
    return items[random_below(stream, next++, items.size())];
  }
};

}  // namespace cps::city
