#include "production/condition_scene.h"

#include "production/scene_files.h"

namespace cps {

RenderScene& ConditionScene::of(const Plan& plan, const PlannedView& view) {
  if (condition_ == view.condition) return *scene_;
  const PlannedCondition& planned = plan.conditions[view.condition];
  scene_.reset();  // before loading the next one, which would double the memory
  scene_ = build_render_scene(load_scene(plan.scenes[planned.scene], plan.recipe), planned.light.daylight);
  condition_ = view.condition;
  return *scene_;
}

}  // namespace cps
