#include <atomic>
#include <catch2/catch.hpp>
#include <semaphore>

#include "production/condition_scene.h"
#include "tests/production/tiny_dataset.h"

using namespace cps;

namespace {

/// The tiny recipe with four conditions, and a view of each.
struct FourConditions {
  TemporaryFolder folder;
  Plan plan;
  std::vector<PlannedView> views;

  FourConditions() {
    Recipe recipe = tiny_recipe(write_streets(folder.path, 1));
    recipe.conditions_per_scene = 4;
    plan = outline_plan(recipe, find_rig("", {}), plan_scenes(recipe, folder.path));
    for (int condition = 0; condition < 4; ++condition)
      views.push_back(*std::ranges::find(plan.views, condition, &PlannedView::condition));
  }
};

/// Loads empty scenes, and counts them.
struct CountedScenes {
  std::atomic<int> in_memory = 0, most_in_memory = 0;
  std::vector<int> loaded;  ///< conditions in their order

  std::shared_ptr<RenderScene> load(int condition) {
    loaded.push_back(condition);
    most_in_memory = std::max(most_in_memory.load(), ++in_memory);
    Scene ground;
    ground.materials.emplace_back();
    const std::shared_ptr<RenderScene> empty = build_render_scene(ground, {});
    return {empty.get(), [this, empty](RenderScene*) { --in_memory; }};
  }
  ConditionScene::Load loader() {
    return [this](const Plan&, int condition) { return load(condition); };
  }
};

}  // namespace

TEST_CASE("the scene is loaded once per condition") {
  const TinyDataset dataset;
  const std::vector<PlannedView>& views = dataset.plan.views;
  REQUIRE(dataset.plan.conditions.size() == 2);
  ConditionScene loaded;
  const RenderScene* const scene = &loaded.of(dataset.plan, views.front());
  std::filesystem::remove(dataset.scene);  // nothing can be loaded any more
  int same = 0;
  for (const PlannedView& view : views)
    if (view.condition == views.front().condition) {
      CHECK(&loaded.of(dataset.plan, view) == scene);
      ++same;
    }
  CHECK(same > 1);
  REQUIRE(views.back().condition != views.front().condition);
  CHECK_THROWS_AS(loaded.of(dataset.plan, views.back()), std::runtime_error);
}

TEST_CASE("a prefetched scene is loaded once, and no more than two are in memory") {
  const FourConditions four;
  CountedScenes scenes;
  {
    ConditionScene loaded(scenes.loader());
    for (std::size_t c = 0; c < 4; ++c) {
      loaded.of(four.plan, four.views[c]);
      for (std::size_t later = c; later < 4; ++later) loaded.prefetch(four.plan, four.views[later]);
    }
    CHECK(scenes.loaded == std::vector<int>{0, 1, 2, 3});
    CHECK(scenes.in_memory == 1);
  }
  CHECK(scenes.in_memory == 0);
  CHECK(scenes.most_in_memory <= 2);
}

TEST_CASE("the next scene loads while the current one is there to be rendered") {
  const FourConditions four;
  CountedScenes scenes;
  std::binary_semaphore begun(0), go_on(0), ended(0);
  ConditionScene loaded([&](const Plan&, int condition) {
    if (condition == 1) {
      begun.release();
      go_on.acquire();
    }
    std::shared_ptr<RenderScene> scene = scenes.load(condition);
    if (condition == 1) ended.release();
    return scene;
  });
  const RenderScene* const current = &loaded.of(four.plan, four.views[0]);
  loaded.prefetch(four.plan, four.views[1]);
  begun.acquire();  // it loads without being waited for
  CHECK(&loaded.of(four.plan, four.views[0]) == current);
  CHECK(scenes.in_memory == 1);
  go_on.release();
  ended.acquire();
  loaded.prefetch(four.plan, four.views[2]);  // would be a third scene
  CHECK(scenes.in_memory == 2);
  loaded.of(four.plan, four.views[1]);
  CHECK(scenes.loaded == std::vector<int>{0, 1});
}

TEST_CASE("an error in loading ahead is thrown by the call for that scene alone, and can be tried again") {
  const FourConditions four;
  CountedScenes scenes;
  std::atomic<bool> fails = true;
  ConditionScene loaded([&](const Plan&, int condition) {
    if (condition == 1 && fails) throw std::runtime_error("b.glb: cannot be read");
    return scenes.load(condition);
  });
  loaded.of(four.plan, four.views[0]);
  loaded.prefetch(four.plan, four.views[1]);
  loaded.of(four.plan, four.views[0]);
  CHECK_THROWS_WITH(loaded.of(four.plan, four.views[1]), "b.glb: cannot be read");
  loaded.prefetch(four.plan, four.views[1]);
  loaded.of(four.plan, four.views[2]);  // not the one that was loaded ahead
  loaded.of(four.plan, four.views[0]);
  fails = false;
  loaded.of(four.plan, four.views[1]);
  CHECK(scenes.loaded == std::vector<int>{0, 2, 0, 1});
  CHECK(scenes.in_memory == 1);
}

TEST_CASE("who loads ahead and then gives up waits for the loading to end") {
  const FourConditions four;
  CountedScenes scenes;
  {
    ConditionScene loaded(scenes.loader());
    loaded.of(four.plan, four.views[0]);
    loaded.prefetch(four.plan, four.views[3]);
  }
  CHECK(scenes.loaded == std::vector<int>{0, 3});
  CHECK(scenes.in_memory == 0);
}
