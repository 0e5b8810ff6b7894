#pragma once

#include <span>
#include <vector>

#include "random/counter_hash.h"
#include "sampler/part.h"

namespace cps {

/// Deals `weights.size()` things out to train, val and test in a drawn order, so that each part's share of
/// the weight comes as near to `train_share`, `val_share` and the rest as whole things allow; each part gets
/// at least one. Needs at least three things.
std::vector<Part> deal_parts(std::span<const double> weights, double train_share, double val_share,
                             Stream stream);

}  // namespace cps
