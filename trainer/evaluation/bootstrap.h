#pragma once

#include <functional>
#include <span>
#include <vector>

#include "numbers/interval.h"
#include "random/counter_hash.h"

namespace cps {

/// 95 % percentile intervals of statistics (Efron 1979), by drawing whole clusters with replacement: images
/// of one place are not independent, and treating them as independent makes intervals too narrow. `clusters`
/// holds each image's cluster; `statistics` gets indices of images, repeated as drawn, and returns its
/// numbers. A pure function of its arguments. With fewer than two clusters or resamples the intervals are
/// unbounded.
std::vector<Interval> bootstrap_intervals(
    std::span<const int> clusters,
    const std::function<std::vector<double>(std::span<const int> images)>& statistics, int resamples,
    Stream stream);

}  // namespace cps
