#pragma once

#include <cstdint>
#include <vector>

#include "random/counter_hash.h"

namespace cps {

/// One of `count` equal pieces of a part's lanes laid end to end.
struct LaneStratum {
  std::int64_t index = 0, count = 1;
};

/// The stratum of each of `count` places: every stratum once, in random order, so that neither the numbers of
/// the places nor their lenses correlate with the position along the lanes.
std::vector<LaneStratum> deal_strata(std::int64_t count, Stream stream);

/// The position along the lanes (0 … 1) of the `attempt`-th try for a place, given `u` in [0, 1): within its
/// stratum at first, then in an ever wider interval around it, finally anywhere.
double stratified(const LaneStratum& stratum, int attempt, double u);

}  // namespace cps
