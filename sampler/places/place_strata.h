#pragma once

#include <cstdint>
#include <vector>

#include "random/counter_hash.h"

namespace cps {

/// One of `count` equal pieces of a part's lanes laid end to end.
struct LaneStratum {
  std::int64_t index = 0, count = 1;
};

/// Which stratum each of `count` places has: every one once, in a drawn order, so that neither the places'
/// numbers nor the lenses that go with them follow the lanes.
std::vector<LaneStratum> deal_strata(std::int64_t count, Stream stream);

/// Where along the lanes (0 … 1) a place is tried for the `attempt`-th time, given `u` in [0, 1): within its
/// stratum, or, if nothing is found there, in an ever wider surrounding of it, in the end everywhere.
double stratified(const LaneStratum& stratum, int attempt, double u);

}  // namespace cps
