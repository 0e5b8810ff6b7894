#include <catch2/catch.hpp>
#include <set>

#include "sampler/scene_plan.h"

using namespace cps;

TEST_CASE("files come first, then cities by seed, then drawn ones, with the styles in turn") {
  Recipe recipe;
  recipe.scenes = {"street.glb"};
  recipe.city_seeds = {7};
  recipe.cities = 3;
  recipe.city_styles = {CityStyle::suburb, CityStyle::downtown};
  const auto scenes = plan_scenes(recipe, "folder");
  REQUIRE(scenes.size() == 5);
  CHECK(scenes[0].file == "street.glb");
  CHECK_FALSE(scenes[0].city);
  CHECK(scenes[1].file == "folder/city_suburb_7.glb");
  REQUIRE(scenes[1].city);
  CHECK(scenes[1].city->seed == 7);
  for (int i = 1; i < 5; ++i)
    CHECK(scenes[i].city->style == (i % 2 == 1 ? CityStyle::suburb : CityStyle::downtown));
}

TEST_CASE("drawn cities differ, follow the recipe's seed, and stay when more are asked for") {
  Recipe recipe;
  recipe.cities = 200;
  const auto scenes = plan_scenes(recipe, "");
  std::set<std::uint64_t> seeds;
  double least = 2, most = 0;
  for (const PlannedScene& scene : scenes) {
    seeds.insert(scene.city->seed);
    least = std::min(least, scene.city->traffic);
    most = std::max(most, scene.city->traffic);
  }
  CHECK(seeds.size() == 200);
  CHECK(least >= recipe.traffic_min);
  CHECK(least < recipe.traffic_min + 0.1);
  CHECK(most <= recipe.traffic_max);
  CHECK(most > recipe.traffic_max - 0.1);
  recipe.cities = 50;
  const auto fewer = plan_scenes(recipe, "");
  for (int i = 0; i < 50; ++i) CHECK(fewer[i].file == scenes[i].file);
  recipe.seed = 1;
  CHECK(plan_scenes(recipe, "")[0].city->seed != scenes[0].city->seed);
}
