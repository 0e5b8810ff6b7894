#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "sampler/plan/scene_plan.h"

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
  CHECK(scenes[1].file == "folder/city_suburb_7_day0.glb");
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

TEST_CASE("each condition of a city is a day with traffic of its own; a city named twice has more days") {
  Recipe recipe;
  recipe.scenes = {"street.glb"};
  recipe.city_seeds = {7, 8, 7};
  recipe.conditions_per_scene = 2;
  const auto scenes = plan_scenes(recipe, "");
  REQUIRE(scenes.size() == 7);
  std::set<std::string> files;
  std::map<std::uint64_t, std::set<std::uint64_t>> days;
  std::set<double> traffic;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    files.insert(scenes[i].file.string());
    days[scenes[i].city->seed].insert(scenes[i].city->traffic_seed);
    traffic.insert(scenes[i].city->traffic);
  }
  CHECK(files.size() == 6);
  CHECK(traffic.size() == 6);
  CHECK(days[7] == std::set<std::uint64_t>{0, 1, 2, 3});
  CHECK(days[8] == std::set<std::uint64_t>{0, 1});
  // The traffic of a day depends on the city alone, not on its position in the recipe.
  Recipe alone = recipe;
  alone.city_seeds = {8};
  const auto same = plan_scenes(alone, "");
  for (int day = 0; day < 2; ++day) {
    CHECK(same[1 + day].file == scenes[3 + day].file);
    CHECK(same[1 + day].city->traffic == scenes[3 + day].city->traffic);
  }
}

TEST_CASE("the same streets are dealt out alike, other streets are not") {
  Recipe recipe;
  recipe.scenes = {"a.glb", "b.glb", "a.glb"};
  recipe.city_seeds = {7, 8, 7};
  recipe.city_styles = {CityStyle::european, CityStyle::suburb};
  recipe.conditions_per_scene = 2;
  const auto scenes = plan_scenes(recipe, "");
  const auto key = [&](std::size_t scene) { return streets_stream(recipe, scenes, scene).key; };
  CHECK(key(0) == key(2));
  CHECK(key(3) == key(4));  // a city's days
  CHECK(key(3) == key(7));  // the same city, named again
  std::set<std::uint64_t> different{key(0), key(1), key(3), key(5)};
  CHECK(different.size() == 4);
}
