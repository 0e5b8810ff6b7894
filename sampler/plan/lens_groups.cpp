#include "sampler/plan/lens_groups.h"

#include <fmt/format.h>

#include "sampler/lenses/shared_master.h"

namespace cps {

SetGroups::SetGroups(Plan& plan, int set, int camera) : plan_(plan), set_(set), camera_(camera) {
  if (plan.recipe.undistorted) undistorted_ = add(0, Part::all, undistorted_lens(plan.sets[set].camera));
}

const SetGroups::Block& SetGroups::block_of(Part part, int rank_in_part) {
  const int views_per_lens = plan_.recipe.views_per_lens;
  const std::pair key(part, views_per_lens > 0 ? rank_in_part / views_per_lens : 0);
  const auto found = blocks_.find(key);
  return found != blocks_.end() ? found->second : blocks_.emplace(key, draw_block(part)).first->second;
}

SetGroups::Block SetGroups::draw_block(Part part) {
  const Recipe& recipe = plan_.recipe;
  Block block;
  std::vector<DrawnLens> lenses;
  if (undistorted_ >= 0) {
    block.groups.push_back(undistorted_);
    lenses.push_back(plan_.groups[undistorted_].lens);
  }
  for (int i = 0; i < recipe.lenses[plan_.sets[set_].size]; ++i) {
    const int number = ++plan_.distorted_lenses;
    lenses.push_back(draw_lens(plan_.sets[set_].camera, recipe.crop_order(), recipe.lens_options,
                               substream(make_stream(recipe.seed, "lens"), number)));
    block.groups.push_back(add(number, part, lenses.back()));
  }
  block.master = shared_master(lenses, recipe.lens_options.bounds.min_eigenvalue);
  return block;
}

int SetGroups::add(int lens_number, Part part, const DrawnLens& lens) {
  plan_.groups.push_back({.folder = fmt::format("{}/{}_lens{:04}", plan_.sets[set_].folder,
                                                plan_.rig.cameras[camera_].name, lens_number),
                          .set = set_,
                          .camera = camera_,
                          .lens_number = lens_number,
                          .part = part,
                          .lens = lens});
  return static_cast<int>(plan_.groups.size()) - 1;
}

}  // namespace cps
