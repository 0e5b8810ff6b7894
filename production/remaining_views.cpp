#include "production/remaining_views.h"

#include <fmt/format.h>

#include <set>

#include "dataset/job/gaps.h"
#include "dataset/job/journal.h"
#include "dataset/job/write_label.h"

namespace cps {

RemainingViews remaining_views(const Plan& plan, const Shard& shard, const std::filesystem::path& root,
                               const Watch& watch) {
  const JournalLines known = read_journals(root);
  if (known.unreadable > 0)
    watch.noted(fmt::format("{}: {} damaged lines in the journals; their views are made again", root.string(),
                            known.unreadable));
  RemainingViews remaining;
  const ViewRange range = views_of(plan, shard);
  for (std::int64_t v = range.begin; v < range.end; ++v) {
    const auto images = static_cast<std::int64_t>(plan.views[v].groups.size());
    remaining.shard_images += images;
    if (is_made(root, plan, v, known.views))
      remaining.made_images += images;
    else
      remaining.views.push_back(v);
  }
  return remaining;
}

void write_labels(const Plan& plan, const std::vector<std::int64_t>& views,
                  const std::filesystem::path& root) {
  std::set<int> groups;
  for (std::int64_t v : views) groups.insert(plan.views[v].groups.begin(), plan.views[v].groups.end());
  for (int g : groups) write_label(root, plan, plan.groups[g]);
}

}  // namespace cps
