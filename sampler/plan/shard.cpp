#include "sampler/plan/shard.h"

#include <stdexcept>
#include <string_view>

#include "sampler/recipe/recipe_values.h"

namespace cps {

std::string to_string(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

Shard shard_from_string(const std::string& text) {
  Shard shard;
  const std::size_t slash = text.find('/');
  try {
    if (slash == text.npos) throw std::runtime_error("no slash");
    parse_value(std::string_view(text).substr(0, slash), shard.index);
    parse_value(std::string_view(text).substr(slash + 1), shard.count);
  } catch (const std::exception&) {
    throw std::runtime_error("is not a shard; write it as 0/4, the first of four");
  }
  if (shard.count < 1 || shard.count > max_shards)
    throw std::runtime_error("the number of shards must lie in [1, 1000000]");
  if (shard.index < 0 || shard.index >= shard.count)
    throw std::runtime_error("shards count from 0: must lie in [0/" + std::to_string(shard.count) + ", " +
                             to_string(Shard{shard.count - 1, shard.count}) + "]");
  return shard;
}

ViewRange views_of(const Plan& plan, const Shard& shard) {
  double total = 0;
  for (const PlannedView& view : plan.views) total += rendered_pixels(plan, view);
  const auto views = static_cast<std::int64_t>(plan.views.size());
  // Pixel counts are whole numbers below 2⁵³, so that their sums are exact and all processes agree on cut i
  // of n.
  const auto cut = [&](std::int64_t i) {
    const double wanted = total * static_cast<double>(i) / static_cast<double>(shard.count);
    double before = 0;
    for (std::int64_t v = 0; v < views; ++v) {
      const double pixels = rendered_pixels(plan, plan.views[v]);
      if (before + pixels / 2 >= wanted) return v;
      before += pixels;
    }
    return views;
  };
  return {cut(shard.index), cut(shard.index + 1)};
}

}  // namespace cps
