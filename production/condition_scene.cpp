#include "production/condition_scene.h"

#include <utility>

#include "production/dense_labels.h"
#include "production/scene_files.h"
#include "renderer/paths/build_render_scene.h"

namespace cps {

std::shared_ptr<LitScene> load_condition(const Plan& plan, int condition, const LightCacheOptions& cache) {
  const PlannedCondition& planned = plan.conditions[condition];
  const Scene scene = load_scene(plan.scenes[planned.scene], plan.recipe);
  auto lit = std::make_shared<LitScene>();
  lit->scene = build_render_scene(scene, planned.light.daylight);
  if (plan.recipe.light_method == LightMethod::cached)
    lit->cache = std::make_unique<LightCache>(scene, *lit->scene, plan.recipe.max_shaded_vertices, cache);
  lit->labels = instance_labels(scene, plan.recipe.labels);
  return lit;
}

LitScene& ConditionScene::of(const Plan& plan, const PlannedView& view) {
  if (condition_ == view.condition) return *scene_;
  condition_ = -1;
  scene_.reset();  // before another one loads, which would be a scene more in memory
  std::future<std::shared_ptr<LitScene>> prefetched = std::move(next_scene_);
  if (std::exchange(next_condition_, -1) == view.condition) {
    scene_ = prefetched.get();
  } else {
    prefetched = {};  // waits for a scene that nobody wants
    scene_ = load_(plan, view.condition);
  }
  condition_ = view.condition;
  return *scene_;
}

void ConditionScene::prefetch(const Plan& plan, const PlannedView& view) {
  if (next_condition_ >= 0 || view.condition == condition_) return;
  next_scene_ = std::async(std::launch::async, [load = load_, &plan, condition = view.condition] {
    return load(plan, condition);
  });
  next_condition_ = view.condition;
}

}  // namespace cps
