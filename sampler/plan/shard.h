#pragma once

#include <cstdint>
#include <string>

#include "sampler/plan/plan.h"

namespace cps {

/// The most shards that a plan can have.
constexpr std::int64_t max_shards = 1'000'000;

/// Slice `index`, from 0, of the `count` slices of a plan that several processes share.
struct Shard {
  std::int64_t index = 0, count = 1;
  bool operator==(const Shard&) const = default;
};

/// `2/8`
std::string to_string(const Shard& shard);

/// Reads what to_string() writes. Throws std::runtime_error in one line that names the form or the range.
Shard shard_from_string(const std::string& text);

/// Views `begin` … `end − 1` of a plan.
struct ViewRange {
  std::int64_t begin = 0, end = 0;
};

/// The views of a shard: contiguous in the plan's order, which is by condition, so that n shards together
/// load at most n − 1 more scenes than one does. All shards have the same number of pixels to render
/// (rendered_pixels()), as nearly as whole views allow. Every view is in exactly one of the n shards; with
/// more shards than views, some are empty.
ViewRange views_of(const Plan& plan, const Shard& shard);

}  // namespace cps
