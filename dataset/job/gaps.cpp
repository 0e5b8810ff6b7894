#include "dataset/job/gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "dataset/job/journal.h"

namespace cps {
namespace {

std::string line_of(const Plan& plan, const std::vector<std::int64_t>& missing, const Shard& shard) {
  const ViewRange range = views_of(plan, shard);
  const auto first = std::lower_bound(missing.begin(), missing.end(), range.begin);
  const auto last = std::lower_bound(first, missing.end(), range.end);
  if (first == last) return "";
  const PlannedView& view = plan.views[*first];
  return fmt::format("shard {}: {} of {} views are missing, the first in {}, {} {}", to_string(shard),
                     last - first, range.end - range.begin, plan.sets[view.set].folder,
                     plan.rig.cameras[view.rig_camera].name, view.index);
}

}  // namespace

bool is_made(const std::filesystem::path& dataset, const Plan& plan, std::int64_t view,
             const std::map<std::int64_t, ViewRecord>& records) {
  const auto record = records.find(view);
  const auto has_labels = [&](const ImageRecord& image) {
    return image.dense.size() == plan.recipe.labels.size();
  };
  return record != records.end() && record->second.images.size() == plan.views[view].groups.size() &&
         std::ranges::all_of(record->second.images, has_labels) &&
         record->second.master.has_value() == plan.recipe.keep_masters &&
         has_its_images(dataset, record->second);
}

Gaps find_gaps(const std::filesystem::path& dataset, const Plan& plan,
               const std::map<std::int64_t, ViewRecord>& records) {
  Gaps gaps;
  const auto views = static_cast<std::int64_t>(plan.views.size());
  for (std::int64_t v = 0; v < views; ++v)
    if (!is_made(dataset, plan, v, records)) gaps.views.push_back(v);
  if (gaps.views.empty()) return gaps;
  for (std::int64_t count : journalled_shard_counts(dataset))
    for (std::int64_t i = 0; i < count; ++i)
      if (std::string line = line_of(plan, gaps.views, {i, count}); !line.empty())
        gaps.lines.push_back(std::move(line));
  gaps.lines.push_back(fmt::format(
      "{} of {} views are missing; run those shards, or cps generate without --shard, and finish again",
      gaps.views.size(), views));
  return gaps;
}

}  // namespace cps
