#pragma once

#include <memory>

#include "renderer/render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Keeps the scene of the last condition, ready to render. One is in memory at a time.
class ConditionScene {
 public:
  /// The scene under the light of the view's condition, loaded unless the last call was for the same
  /// condition. Valid until the next call. Throws as load_scene() does.
  RenderScene& of(const Plan& plan, const PlannedView& view);

 private:
  int condition_ = -1;
  std::shared_ptr<RenderScene> scene_;
};

}  // namespace cps
