#pragma once

#include <cstdint>
#include <string>

#include "sampler/plan/plan.h"

namespace cps {

/// Slice `index` of `count`, counted from 0: what one process of several makes of a plan.
struct Shard {
  std::int64_t index = 0, count = 1;
  bool operator==(const Shard&) const = default;
};

/// `2/8`
std::string to_string(const Shard& shard);

/// The other way. Throws std::runtime_error in one line: what was meant, the range.
Shard shard_from_string(const std::string& text);

/// Views `begin` … `end − 1` of a plan.
struct ViewRange {
  std::int64_t begin = 0, end = 0;
};

/// The shard's views: contiguous in the plan's order, which is by condition, so that n shards load at most
/// n − 1 scenes more than one does; cut so that all have the same number of master pixels to render, as near
/// as whole views allow. The shards of one count have every view once; with more shards than views some have
/// none.
ViewRange views_of(const Plan& plan, const Shard& shard);

}  // namespace cps
