#include "sampler/recipe/recipe_counts.h"

#include <array>

#include "sampler/splits.h"

namespace cps {
namespace {

/// Number of blocks of views that share their lenses, over all parts.
std::int64_t lens_blocks(const Recipe& recipe, int views) {
  const std::vector<double> equal_weights(views, 1.0);
  std::array<std::int64_t, 3> views_of_part = {};
  for (Part part : deal_parts(equal_weights, recipe.train_share, recipe.val_share, make_stream(0, "count")))
    ++views_of_part[static_cast<int>(part)];
  std::int64_t blocks = 0;
  for (std::int64_t count : views_of_part)
    blocks += recipe.views_per_lens == 0 ? 1 : (count + recipe.views_per_lens - 1) / recipe.views_per_lens;
  return blocks;
}

}  // namespace

RecipeCounts count_out(const Recipe& recipe, int cameras) {
  RecipeCounts counts;
  counts.scenes = static_cast<std::int64_t>(recipe.scenes.size() + recipe.city_seeds.size()) + recipe.cities;
  counts.conditions = counts.scenes * recipe.conditions_per_scene;
  const auto given = static_cast<std::int64_t>(recipe.scenes.size());
  counts.scene_files = given + (counts.scenes - given) * recipe.conditions_per_scene;
  const auto hfovs = static_cast<std::int64_t>(recipe.base_hfov_deg.size() + recipe.hfov_deg.size());
  counts.sets = static_cast<std::int64_t>(recipe.sizes.size()) * hfovs;
  for (std::size_t s = 0; s < recipe.sizes.size(); ++s) {
    const std::int64_t views = hfovs * cameras * recipe.views[s];
    const int undistorted = recipe.undistorted ? 1 : 0;
    counts.views += views;
    counts.images += views * (undistorted + recipe.lenses[s]);
    counts.groups +=
        hfovs * cameras * (undistorted + lens_blocks(recipe, recipe.views[s]) * recipe.lenses[s]);
  }
  return counts;
}

}  // namespace cps
