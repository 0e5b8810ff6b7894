#pragma once

#include <functional>
#include <future>
#include <memory>

#include "production/lit_scene.h"
#include "sampler/plan/plan.h"

namespace cps {

/// Loads the scene of a condition (index into plan.conditions) and prepares it for rendering in its light,
/// with a cache if the recipe wants one. Throws as load_scene() and build_render_scene() do.
std::shared_ptr<LitScene> load_condition(const Plan& plan, int condition,
                                         const LightCacheOptions& cache = {});

/// Keeps the scene of the last condition, ready to render, and loads the one that comes next meanwhile. At
/// most these two are in memory.
class ConditionScene {
 public:
  using Load = std::function<std::shared_ptr<LitScene>(const Plan&, int)>;

  explicit ConditionScene(Load load) : load_(std::move(load)) {}
  explicit ConditionScene(const LightCacheOptions& cache = {})
      : load_([cache](const Plan& plan, int condition) { return load_condition(plan, condition, cache); }) {}

  /// The scene under the light of the view's condition, loaded unless the last call was for the same
  /// condition. Valid until the next call. Throws what loading throws, when it was prefetched as well.
  LitScene& of(const Plan& plan, const PlannedView& view);

  /// Begins to load the scene of another condition, on a thread of its own, so that of() will find it. Does
  /// nothing while a prefetched scene waits for its of(). The plan must outlive this object, whose destructor
  /// waits for the loading to end.
  void prefetch(const Plan& plan, const PlannedView& view);

 private:
  Load load_;
  int condition_ = -1, next_condition_ = -1;  ///< -1: none
  std::shared_ptr<LitScene> scene_;
  std::future<std::shared_ptr<LitScene>> next_scene_;  ///< made by std::async: its destructor waits
};

}  // namespace cps
