#include "sampler/places/place_strata.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cps {

std::vector<LaneStratum> deal_strata(std::int64_t count, Stream stream) {
  std::vector<std::int64_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
    return std::pair(random_bits(stream, a), a) < std::pair(random_bits(stream, b), b);
  });
  std::vector<LaneStratum> strata;
  for (std::int64_t index : order) strata.push_back({index, count});
  return strata;
}

double stratified(const LaneStratum& stratum, int attempt, double u) {
  constexpr int attempts_inside = 20, attempts_per_doubling = 6;
  const double own = 1.0 / static_cast<double>(stratum.count);
  const int doublings = std::max(0, attempt - attempts_inside) / attempts_per_doubling;
  const double width = std::min(1.0, std::ldexp(own, doublings));
  const double middle = (static_cast<double>(stratum.index) + 0.5) * own;
  return std::clamp(middle - width / 2, 0.0, 1 - width) + width * u;
}

}  // namespace cps
