#include <catch2/catch.hpp>

#include "production/condition_scene.h"
#include "tests/production/tiny_dataset.h"

using namespace cps;

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
