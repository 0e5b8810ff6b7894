#pragma once

#include <functional>
#include <future>
#include <memory>

#include "renderer/render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Loads the scene of a condition (index into plan.conditions) and prepares it for rendering in its light.
/// Throws as load_scene() and build_render_scene() do.
std::shared_ptr<RenderScene> load_condition(const Plan& plan, int condition);

/// Keeps the scene of the last condition, ready to render, and loads the one that comes next meanwhile. At
/// most these two are in memory.
class ConditionScene {
 public:
  using Load = std::function<std::shared_ptr<RenderScene>(const Plan&, int)>;

  explicit ConditionScene(Load load = load_condition) : load_(std::move(load)) {}

  /// The scene under the light of the view's condition, loaded unless the last call was for the same
  /// condition. Valid until the next call. Throws what loading throws, when it was prefetched as well.
  RenderScene& of(const Plan& plan, const PlannedView& view);

  /// Begins to load the scene of another condition, on a thread of its own, so that of() will find it. Does
  /// nothing while a prefetched scene waits for its of(). The plan must outlive this object, whose destructor
  /// waits for the loading to end.
  void prefetch(const Plan& plan, const PlannedView& view);

 private:
  Load load_;
  int condition_ = -1, next_condition_ = -1;  ///< -1: none
  std::shared_ptr<RenderScene> scene_;
  std::future<std::shared_ptr<RenderScene>> next_scene_;  ///< made by std::async: its destructor waits
};

}  // namespace cps
