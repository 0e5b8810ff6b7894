#include "sampler/plan/place_views.h"

#include <algorithm>
#include <map>

#include "scenes/classes/semantic_classes.h"
#include "scenes/ego_bonnet.h"

namespace cps {
namespace {

int scene_of(const Plan& plan, std::int64_t view) {
  return plan.conditions[plan.views[view].condition].scene;
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

/// The classes of what is rendered: the bonnet is no part of the scene's file.
std::vector<SemanticClass> classes_of(Scene scene, const Recipe& recipe) {
  if (recipe.ego_bonnet) add_ego_bonnet(scene);
  return semantic_classes(scene).classes;
}

DrivableScene load_drivable(Plan& plan, int s, const LoadDrivenScene& load) {
  PlannedScene& planned = plan.scenes[s];
  DrivenScene driven = load(planned.file);
  planned.metres_per_unit = driven.metres_per_unit;
  planned.is_z_up = driven.is_z_up;
  planned.credits = driven.scene.credits;
  planned.import_warnings = driven.scene.import_warnings;
  planned.origin = driven.scene.origin;
  DrivableScene drivable = drivable_scene(driven.scene, planned.file.string(), plan.recipe,
                                          streets_stream(plan.recipe, plan.scenes, s));
  // Refuses scenes that cannot be labelled before anything is rendered.
  if (std::ranges::count(plan.recipe.labels, DenseLabel::instance) > 0) object_ids(driven.scene);
  if (std::ranges::count(plan.recipe.labels, DenseLabel::semantic) > 0)
    planned.classes = classes_of(std::move(driven.scene), plan.recipe);
  return drivable;
}

}  // namespace

std::vector<int> scenes_of(const Plan& plan, const std::vector<std::int64_t>& views) {
  std::vector<int> scenes;
  for (std::int64_t v : views)
    if (scenes.empty() || scenes.back() != scene_of(plan, v)) scenes.push_back(scene_of(plan, v));
  return scenes;
}

void place_views(Plan& plan, const std::vector<std::int64_t>& views, const LoadDrivenScene& load) {
  if (views.empty()) return;
  const std::vector<LaneStratum> strata = strata_of_views(plan);
  // The views are sorted by condition, the conditions of a scene are contiguous, and so are the cameras of a
  // place.
  for (auto v = views.begin(); v != views.end();) {
    const int s = scene_of(plan, *v);
    const DrivableScene scene = load_drivable(plan, s, load);
    std::int64_t placed = -1;  // the view of the rig's first camera at the place that was drawn last
    DrawnPlace drawn;
    for (; v != views.end() && scene_of(plan, *v) == s; ++v) {
      PlannedView& view = plan.views[*v];
      if (const std::int64_t first = *v - view.rig_camera; first != placed) {
        drawn = draw_place(scene, plan.rig, view.part, plan.recipe, strata[first],
                           make_stream(plan.views[first].seed, "place"));
        plan.places.add(drawn.tally);
        placed = first;
      }
      view.street = drawn.street;
      view.place = drawn.place;
      view.camera = drawn.cameras[view.rig_camera];
    }
  }
}

}  // namespace cps
