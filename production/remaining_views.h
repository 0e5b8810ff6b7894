#pragma once

#include <filesystem>
#include <vector>

#include "production/watch.h"
#include "sampler/plan/shard.h"

namespace cps {

/// Views of a shard not yet rendered.
struct RemainingViews {
  std::vector<std::int64_t> views;  ///< indices into Plan::views, ascending
  std::int64_t shard_images = 0;    ///< of all the shard's views
  std::int64_t made_images = 0;     ///< of those that need no rendering
};

/// Compares the shard with the folder's journals and files. Notes damaged lines of the journals, whose views
/// remain.
RemainingViews remaining_views(const Plan& plan, const Shard& shard, const std::filesystem::path& root,
                               const Watch& watch);

/// Writes calibration.json, and valid.png where the lens needs one, of every group that one of the views
/// belongs to.
void write_labels(const Plan& plan, const std::vector<std::int64_t>& views,
                  const std::filesystem::path& root);

}  // namespace cps
