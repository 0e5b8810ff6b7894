#pragma once

#include <span>
#include <vector>

#include "random/counter_hash.h"
#include "sampler/part.h"

namespace cps {

/// Assigns items with these weights to train, val and test in random order, so that the parts' shares of the
/// weight come as close to `train_share`, `val_share` and the rest as whole items allow. Every part gets at
/// least one item; there must be at least three.
std::vector<Part> deal_parts(std::span<const double> weights, double train_share, double val_share,
                             Stream stream);

}  // namespace cps
