#include "sampler/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "numbers/angles.h"
#include "sampler/plan/lens_groups.h"
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

std::vector<PlannedSet> plan_sets(const Recipe& recipe) {
  std::vector<PlannedSet> sets;
  for (std::size_t s = 0; s < recipe.sizes.size(); ++s)
    for (double hfov_deg :
         recipe.crop_order() == CropOrder::base_first ? recipe.base_hfov_deg : recipe.hfov_deg) {
      const ImageSize& size = recipe.sizes[s];
      sets.push_back(
          {.folder = fmt::format("{}x{}_hfov{:03}", size.width, size.height, std::lround(hfov_deg)),
           .size = static_cast<int>(s),
           .camera = pinhole_from_hfov(size.width, size.height, radians(hfov_deg))});
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

/// The stratum of each view: the places of a set in the same streets, on any day, share the strata.
std::vector<LaneStratum> strata_of_views(const Plan& plan) {
  const bool shares_streets = plan.recipe.split == "thesis";
  std::map<std::uint64_t, std::vector<std::size_t>> views_of;  // views by the lanes that they share
  for (std::size_t v = 0; v < plan.views.size(); ++v) {
    const PlannedView& view = plan.views[v];
    if (view.rig_camera != 0) continue;
    const Stream streets = streets_stream(plan.recipe, plan.scenes, plan.conditions[view.condition].scene);
    const Part part = shares_streets ? Part::all : view.part;
    views_of[substream(make_stream(streets.key, to_string(part)), view.set).key].push_back(v);
  }
  std::vector<LaneStratum> strata(plan.views.size());
  for (const auto& [key, views] : views_of) {
    const auto dealt = deal_strata(static_cast<std::int64_t>(views.size()), make_stream(key, "strata"));
    for (std::size_t i = 0; i < views.size(); ++i) strata[views[i]] = dealt[i];
  }
  return strata;
}

/// Draws the places of all views, with one scene in memory at a time. `plan.views` is sorted by condition,
/// and the conditions of a scene are contiguous.
void plan_places(Plan& plan, const std::function<DrivenScene(const std::filesystem::path&)>& load) {
  const std::vector<LaneStratum> strata = strata_of_views(plan);
  std::size_t v = 0;
  while (v < plan.views.size()) {
    const int s = plan.conditions[plan.views[v].condition].scene;
    const DrivenScene driven = load(plan.scenes[s].file);
    plan.scenes[s].metres_per_unit = driven.metres_per_unit;
    plan.scenes[s].is_z_up = driven.is_z_up;
    plan.scenes[s].credits = driven.scene.credits;
    plan.scenes[s].import_warnings = driven.scene.import_warnings;
    plan.scenes[s].origin = driven.scene.origin;
    const DrivableScene scene = drivable_scene(driven.scene, plan.scenes[s].file.string(), plan.recipe,
                                               streets_stream(plan.recipe, plan.scenes, s));
    DrawnPlace drawn;
    for (; v < plan.views.size() && plan.conditions[plan.views[v].condition].scene == s; ++v) {
      PlannedView& view = plan.views[v];
      if (view.rig_camera == 0) {
        drawn =
            draw_place(scene, plan.rig, view.part, plan.recipe, strata[v], make_stream(view.seed, "place"));
        plan.places.add(drawn.tally);
      }
      view.street = drawn.street;
      view.place = drawn.place;
      view.camera = drawn.cameras[view.rig_camera];
    }
  }
}

}  // namespace

std::int64_t image_count(const Plan& plan) {
  std::int64_t count = 0;
  for (const PlannedView& view : plan.views) count += static_cast<std::int64_t>(view.groups.size());
  return count;
}

std::string image_name(const Plan& plan, const PlannedView& view) {
  return fmt::format("{:06}.{}", view.index, extension_of(plan.recipe.image_format));
}

Plan make_plan(const Recipe& recipe, const Rig& rig, std::vector<PlannedScene> scenes,
               const std::function<DrivenScene(const std::filesystem::path&)>& load) {
  Plan plan;
  plan.recipe = recipe;
  plan.rig = rig;
  plan.scenes = std::move(scenes);
  plan.conditions = plan_conditions(recipe, plan.scenes);
  plan.sets = plan_sets(recipe);
  for (int set = 0; set < static_cast<int>(plan.sets.size()); ++set) plan_views_of_set(plan, set);
  std::stable_sort(plan.views.begin(), plan.views.end(),
                   [](const PlannedView& a, const PlannedView& b) { return a.condition < b.condition; });
  plan_places(plan, load);
  return plan;
}

}  // namespace cps
