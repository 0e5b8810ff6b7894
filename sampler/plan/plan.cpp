#include "sampler/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numbers/angles.h"
#include "sampler/plan/lens_groups.h"
#include "sampler/plan/place_views.h"
#include "sampler/splits.h"

namespace cps {
namespace {

/// A city comes as one scene per condition (day), a file as one scene for all its conditions.
std::vector<PlannedCondition> plan_conditions(const Recipe& recipe, const std::vector<PlannedScene>& scenes) {
  std::vector<PlannedCondition> conditions;
  for (int scene = 0; scene < static_cast<int>(scenes.size()); ++scene)
    for (int i = 0; i < (scenes[scene].city ? 1 : recipe.conditions_per_scene); ++i) {
      const Stream stream = substream(make_stream(recipe.seed, "condition"), conditions.size());
      conditions.push_back({.scene = scene, .light = draw_light(recipe.light, stream)});
    }
  return conditions;
}

PlannedSet plan_set(const Recipe& recipe, std::size_t size, double hfov_deg) {
  const auto [width, height] = recipe.sizes[size];
  const long whole_deg = std::lround(hfov_deg);
  PlannedSet set{.folder = fmt::format("{}x{}_hfov{:03}", width, height, whole_deg),
                 .size = static_cast<int>(size),
                 .hfov_deg = hfov_deg,
                 .camera = {.width = width, .height = height}};
  if (recipe.is_brown_conrady())
    set.camera = pinhole_from_hfov(width, height, radians(hfov_deg));
  else
    set.folder = fmt::format("{}x{}_{}_hfov{:03}", width, height, recipe.lens_model, whole_deg);
  return set;
}

std::vector<PlannedSet> plan_sets(const Recipe& recipe) {
  std::vector<PlannedSet> sets;
  for (std::size_t s = 0; s < recipe.sizes.size(); ++s)
    for (double hfov_deg :
         recipe.crop_order() == CropOrder::base_first ? recipe.base_hfov_deg : recipe.hfov_deg) {
      sets.push_back(plan_set(recipe, s, hfov_deg));
      for (std::size_t other = 0; other + 1 < sets.size(); ++other)
        if (sets[other].folder == sets.back().folder)
          throw std::runtime_error("recipe: size, base_hfov_deg, hfov_deg: two sets would share the folder " +
                                   sets.back().folder + "; name each once, in whole degrees");
    }
  return sets;
}

void plan_views_of_set(Plan& plan, int set) {
  const Recipe& recipe = plan.recipe;
  const Stream set_stream = substream(make_stream(recipe.seed, "view"), set);
  const int views = recipe.views[plan.sets[set].size];
  const std::vector<double> equal_weights(views, 1.0);
  const std::vector<Part> parts =
      deal_parts(equal_weights, recipe.train_share, recipe.val_share, make_stream(set_stream.key, "part"));
  std::vector<SetGroups> groups_of_camera;
  for (int camera = 0; camera < static_cast<int>(plan.rig.cameras.size()); ++camera)
    groups_of_camera.emplace_back(plan, set, camera);
  int rank_in_part[3] = {0, 0, 0};
  for (int index = 0; index < views; ++index) {
    const Part part = parts[index];
    const int rank = rank_in_part[static_cast<int>(part)]++;
    for (int camera = 0; camera < static_cast<int>(plan.rig.cameras.size()); ++camera) {
      const SetGroups::Block& block = groups_of_camera[camera].block_of(part, rank);
      plan.views.push_back(
          {.set = set,
           .index = index,
           .rig_camera = camera,
           .condition = static_cast<int>(static_cast<std::int64_t>(index) *
                                         static_cast<std::int64_t>(plan.conditions.size()) / views),
           .part = part,
           .street = {},
           .place = {},
           .camera = plan.rig.cameras[camera],
           .seed = random_bits(substream(set_stream, camera), index),
           .master = block.master,
           .groups = block.groups});
    }
  }
}

}  // namespace

std::int64_t image_count(const Plan& plan) {
  std::int64_t count = 0;
  for (const PlannedView& view : plan.views) count += static_cast<std::int64_t>(view.groups.size());
  return count;
}

double rendered_pixels(const Plan& plan, const PlannedView& view) {
  const auto pixels = [](const Pinhole& camera) { return static_cast<double>(camera.width) * camera.height; };
  if (view.master.width > 0) return pixels(view.master);
  double sum = 0;
  for (int g : view.groups) sum += pixels(plan.groups[g].model->pinhole);
  return sum;
}

std::vector<std::int64_t> all_views(const Plan& plan) {
  std::vector<std::int64_t> views(plan.views.size());
  std::iota(views.begin(), views.end(), 0);
  return views;
}

std::string image_name(const Plan& plan, const PlannedView& view) {
  return fmt::format("{:06}.{}", view.index, extension_of(plan.recipe.image_format));
}

Plan outline_plan(const Recipe& recipe, const Rig& rig, std::vector<PlannedScene> scenes) {
  Plan plan;
  plan.recipe = recipe;
  plan.rig = rig;
  plan.scenes = std::move(scenes);
  plan.conditions = plan_conditions(recipe, plan.scenes);
  plan.sets = plan_sets(recipe);
  for (int set = 0; set < static_cast<int>(plan.sets.size()); ++set) plan_views_of_set(plan, set);
  std::stable_sort(plan.views.begin(), plan.views.end(),
                   [](const PlannedView& a, const PlannedView& b) { return a.condition < b.condition; });
  return plan;
}

Plan make_plan(const Recipe& recipe, const Rig& rig, std::vector<PlannedScene> scenes,
               const LoadDrivenScene& load) {
  Plan plan = outline_plan(recipe, rig, std::move(scenes));
  place_views(plan, all_views(plan), load);
  return plan;
}

}  // namespace cps
