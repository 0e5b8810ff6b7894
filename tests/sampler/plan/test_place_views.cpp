#include <catch2/catch.hpp>

#include "sampler/plan/place_views.h"
#include "tests/sampler/plain_scene.h"

using namespace cps;

namespace {

Recipe three_scenes() {
  Recipe recipe;
  recipe.scenes = {"a.glb", "b.glb", "c.glb"};
  recipe.conditions_per_scene = 2;
  recipe.sizes = {{96, 54}, {64, 64}};
  recipe.base_hfov_deg = {60, 110};
  recipe.views = 12;
  recipe.lenses = 2;
  recipe.views_per_lens = 8;
  return recipe;
}

const Rig two_cameras{.cameras = {{.name = "left", .position_m = {1, 0.5, 1.5}},
                                  {.name = "right", .position_m = {1, -0.5, 1.5}}}};

/// Loads the plain scene for every file, and notes which were asked for.
struct Loader {
  std::vector<std::string> loaded = {};
  LoadDrivenScene load() {
    return [this](const std::filesystem::path& file) {
      loaded.push_back(file.string());
      return DrivenScene{.scene = plain_scene(8), .metres_per_unit = 2};
    };
  }
};

}  // namespace

TEST_CASE("views that are placed in parts get the places of the whole plan, from their own scenes") {
  const Recipe recipe = three_scenes();
  Loader for_all;
  const Plan whole = make_plan(recipe, two_cameras, plan_scenes(recipe, "cities"), for_all.load());
  CHECK(for_all.loaded == std::vector<std::string>{"a.glb", "b.glb", "c.glb"});
  const auto count = static_cast<std::int64_t>(whole.views.size());
  REQUIRE(count == 96);
  PlaceTally places;
  // Cut between the two cameras of a place.
  for (const auto& [begin, end] :
       std::vector<std::pair<std::int64_t, std::int64_t>>{{0, 33}, {33, 34}, {34, 96}}) {
    Plan plan = outline_plan(recipe, two_cameras, plan_scenes(recipe, "cities"));
    std::vector<std::int64_t> views;
    for (std::int64_t v = begin; v < end; ++v) views.push_back(v);
    Loader loader;
    place_views(plan, views, loader.load());
    std::vector<std::string> expected;
    for (int s : scenes_of(plan, views)) expected.push_back(recipe.scenes[s]);
    CHECK(loader.loaded == expected);
    places.add(plan.places);

    REQUIRE(plan.views.size() == whole.views.size());
    for (std::int64_t v : views) {
      CHECK(plan.views[v].place.position == whole.views[v].place.position);
      CHECK(plan.views[v].place.heading_rad == whole.views[v].place.heading_rad);
      CHECK(plan.views[v].street == whole.views[v].street);
      CHECK(plan.views[v].camera.yaw_deg == whole.views[v].camera.yaw_deg);
      CHECK(plan.views[v].camera.name == whole.views[v].camera.name);
    }
    // What needs no scene is the same in all views.
    for (std::int64_t v = 0; v < count; ++v) {
      CHECK(plan.views[v].seed == whole.views[v].seed);
      CHECK(plan.views[v].groups == whole.views[v].groups);
      CHECK(plan.views[v].master == whole.views[v].master);
    }
    for (std::size_t g = 0; g < whole.groups.size(); ++g)
      CHECK(plan.groups[g].lens.distortion == whole.groups[g].lens.distortion);
    for (std::size_t s = 0; s < recipe.scenes.size(); ++s) {
      const bool is_loaded = std::ranges::count(expected, recipe.scenes[s]) > 0;
      CHECK(plan.scenes[s].metres_per_unit == (is_loaded ? 2 : 1));
    }
  }
  CHECK(whole.places.drawn - whole.places.rejected() == 48);
  CHECK(places.drawn - places.rejected() == 48 + 1);  // the place that was cut is drawn twice
}

TEST_CASE("no views need no scene") {
  const Recipe recipe = three_scenes();
  Plan plan = outline_plan(recipe, Rig{}, plan_scenes(recipe, "cities"));
  Loader loader;
  place_views(plan, {}, loader.load());
  CHECK(loader.loaded.empty());
  CHECK(scenes_of(plan, {}).empty());
  CHECK(scenes_of(plan, all_views(plan)) == std::vector<int>{0, 1, 2});
  CHECK(plan.places.drawn == 0);
}
