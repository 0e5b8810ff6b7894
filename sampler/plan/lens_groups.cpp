#include "sampler/plan/lens_groups.h"

#include <fmt/format.h>

#include "numbers/angles.h"
#include "sampler/lenses/family_draw.h"
#include "sampler/lenses/shared_master.h"

namespace cps {

SetGroups::SetGroups(Plan& plan, int set, int camera) : plan_(plan), set_(set), camera_(camera) {
  if (!plan.recipe.undistorted) return;
  add(0, Part::all).lens = undistorted_lens(plan.sets[set].camera);
  undistorted_ = last_group();
}

const SetGroups::Block& SetGroups::block_of(Part part, int rank_in_part) {
  const int views_per_lens = plan_.recipe.views_per_lens;
  const std::pair key(part, views_per_lens > 0 ? rank_in_part / views_per_lens : 0);
  const auto found = blocks_.find(key);
  return found != blocks_.end() ? found->second : blocks_.emplace(key, draw_block(part)).first->second;
}

SetGroups::Block SetGroups::draw_block(Part part) {
  const Recipe& recipe = plan_.recipe;
  if (!recipe.is_brown_conrady()) return draw_family_block(part);
  Block block;
  std::vector<DrawnLens> lenses;
  if (undistorted_ >= 0) {
    block.groups.push_back(undistorted_);
    lenses.push_back(plan_.groups[undistorted_].lens);
  }
  for (int i = 0; i < recipe.lenses[plan_.sets[set_].size]; ++i) {
    const auto [number, stream] = next_lens();
    lenses.push_back(draw_lens(plan_.sets[set_].camera, recipe.crop_order(), recipe.lens_options, stream));
    add(number, part).lens = lenses.back();
    block.groups.push_back(last_group());
  }
  block.master = shared_master(lenses, recipe.lens_options.bounds.min_eigenvalue);
  return block;
}

SetGroups::Block SetGroups::draw_family_block(Part part) {
  const Recipe& recipe = plan_.recipe;
  const PlannedSet& set = plan_.sets[set_];
  Block block;
  for (int i = 0; i < recipe.lenses[set.size]; ++i) {
    const auto [number, stream] = next_lens();
    add(number, part).model =
        draw_family_camera(recipe.lens_model, recipe.sizes[set.size], radians(set.hfov_deg), stream);
    block.groups.push_back(last_group());
  }
  return block;
}

std::pair<int, Stream> SetGroups::next_lens() {
  const int number = ++plan_.distorted_lenses;
  return {number, substream(make_stream(plan_.recipe.seed, "lens"), number)};
}

PlannedGroup& SetGroups::add(int lens_number, Part part) {
  plan_.groups.push_back({.folder = fmt::format("{}/{}_lens{:04}", plan_.sets[set_].folder,
                                                plan_.rig.cameras[camera_].name, lens_number),
                          .set = set_,
                          .camera = camera_,
                          .lens_number = lens_number,
                          .part = part,
                          .lens = {}});
  return plan_.groups.back();
}

}  // namespace cps
