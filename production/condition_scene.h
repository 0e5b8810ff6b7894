#pragma once

#include <memory>

#include "renderer/render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// The scene of one condition at a time, ready to be rendered.
class ConditionScene {
 public:
  /// The scene under the light of the view's condition; loaded if it is another than before.
  RenderScene& of(const Plan& plan, const PlannedView& view);

 private:
  int condition_ = -1;
  std::shared_ptr<RenderScene> scene_;
};

}  // namespace cps
