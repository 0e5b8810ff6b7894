#include "sampler/lens_groups.h"

#include <fmt/format.h>

namespace cps {

SetGroups::SetGroups(Plan& plan, int set) : plan_(plan), set_(set) {
  undistorted_ = add(0, Part::all, undistorted_lens(plan.sets[set].base));
}

std::vector<int> SetGroups::groups_for(Part part, int rank_in_part) {
  const Recipe& recipe = plan_.recipe;
  const int block = recipe.views_per_lens > 0 ? rank_in_part / recipe.views_per_lens : 0;
  const auto [found, is_new] = blocks_.try_emplace({part, block}, std::vector<int>{undistorted_});
  if (is_new) {
    const PlannedSet& set = plan_.sets[set_];
    for (int i = 0; i < recipe.lenses; ++i) {
      const int number = ++plan_.distorted_lenses;
      const Stream stream = substream(make_stream(recipe.seed, "lens"), number);
      found->second.push_back(add(number, part, draw_lens(set.base, recipe.lens_options, stream)));
    }
  }
  return found->second;
}

int SetGroups::add(int lens_number, Part part, const DrawnLens& lens) {
  plan_.groups.push_back(
      {.folder = fmt::format("{}/{}_lens{:04}", plan_.sets[set_].folder, plan_.camera.name, lens_number),
       .set = set_,
       .lens_number = lens_number,
       .part = part,
       .lens = lens});
  return static_cast<int>(plan_.groups.size()) - 1;
}

}  // namespace cps
