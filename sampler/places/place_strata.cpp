#include "sampler/places/place_strata.h"

#include <algorithm>
#include <cmath>

#include "random/shuffle.h"

namespace cps {

std::vector<LaneStratum> deal_strata(std::int64_t count, Stream stream) {
  std::vector<LaneStratum> strata;
  for (std::size_t index : shuffled_order(count, stream))
    strata.push_back({static_cast<std::int64_t>(index), count});
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
