#include <boost/program_options.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "sampler/plan/plan.h"
#include "sampler/recipe/recipe_counts.h"
#include "sampler/recipe/recipe_scale.h"
#include "sampler/recipe/rig_file.h"
#include "tests/sampler/plain_scene.h"

namespace po = boost::program_options;
using namespace cps;

namespace {

Recipe shipped(const std::string& name, const std::vector<std::string>& flags = {}) {
  po::variables_map values;
  po::store(po::command_line_parser(flags).options(recipe_options()).run(), values);
  store_recipe_file(std::filesystem::path(CPS_RECIPES) / (name + ".cfg"), values);
  return recipe_from(values);
}

RecipeCounts counts_of(const Recipe& recipe) {
  return count_out(recipe, static_cast<int>(find_rig(recipe.rig, CPS_RECIPES).cameras.size()));
}

Plan plan_in_plain_scene(Recipe recipe) {
  recipe.scenes = {"plain.glb"};
  recipe.city_seeds.clear();
  recipe.cities = 0;
  return make_plan(recipe, find_rig(recipe.rig, CPS_RECIPES), plan_scenes(recipe, ""),
                   [](const std::filesystem::path&) { return DrivenScene{.scene = plain_scene(6)}; });
}

}  // namespace

TEST_CASE("every shipped recipe makes as many views and images as it says") {
  struct Published {
    std::int64_t sets, views, images;
  };
  const std::map<std::string, Published> published = {{"cps-v1", {7, 70'000, 70'000}},
                                                      {"cps-v2", {13, 130'000, 780'000}},
                                                      {"cps-v3", {26, 195'000, 1'495'000}},
                                                      {"kitti", {10, 16'000, 80'000}},
                                                      {"wide-aspects", {48, 24'000, 120'000}},
                                                      {"smoke", {8, 720, 2'160}},
                                                      {"small", {31, 3'100, 9'300}},
                                                      {"reference", {38, 6'080, 30'400}},
                                                      {"demo", {5, 60, 240}},
                                                      {"fisheye", {8, 360, 720}},
                                                      {"deepcalib", {14, 28'000, 28'000}}};
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CPS_RECIPES)) {
    if (entry.path().extension() != ".cfg") continue;
    const std::string name = entry.path().stem();
    INFO(name);
    REQUIRE(published.contains(name));
    const Recipe recipe = shipped(name);
    const RecipeCounts counts = counts_of(recipe);
    CHECK(recipe.name == name);
    CHECK(counts.sets == published.at(name).sets);
    CHECK(counts.views == published.at(name).views);
    CHECK(counts.images == published.at(name).images);
    // The lens' number has four digits in a folder's name.
    CHECK(counts.groups < 10'000);
    // A condition's city costs as much as a few views; `reference` has many, for the variety of its streets.
    if (counts.images > 10'000) CHECK(counts.views / counts.conditions >= (name == "reference" ? 76 : 200));
    ++found;
  }
  CHECK(found == static_cast<int>(published.size()));
}

TEST_CASE("what is counted without a plan is what the plan comes to") {
  for (const char* name : {"cps-v1", "cps-v3", "kitti", "wide-aspects", "fisheye"}) {
    INFO(name);
    Recipe recipe = shipped(name, {"--scale", "0.002"});
    recipe.views_per_lens = 4;
    const Plan plan = plan_in_plain_scene(recipe);
    const RecipeCounts counts = counts_of(plan.recipe);
    CHECK(counts.scenes == static_cast<std::int64_t>(plan.scenes.size()));
    CHECK(counts.conditions == static_cast<std::int64_t>(plan.conditions.size()));
    CHECK(counts.sets == static_cast<std::int64_t>(plan.sets.size()));
    CHECK(counts.groups == static_cast<std::int64_t>(plan.groups.size()));
    CHECK(counts.views == static_cast<std::int64_t>(plan.views.size()));
    CHECK(counts.images == image_count(plan));
  }
}

TEST_CASE(
    "cps-v1's lenses have k1 alone, inside the thesis' interval and evenly spread where it is allowed") {
  const Plan plan = plan_in_plain_scene(shipped("cps-v1", {"--scale", "0.005"}));
  int at_90 = 0, strong_at_90 = 0;
  for (const PlannedGroup& group : plan.groups) {
    const Distortion& lens = group.lens.distortion;
    CHECK(group.lens_number > 0);
    CHECK((lens.k1 != 0 && lens.k2 == 0 && lens.k3 == 0 && lens.p1 == 0 && lens.p2 == 0));
    const Interval limits = *group.lens.limits[0];
    CHECK((limits.low >= -0.2 - 1e-15 && limits.high <= 0.2 + 1e-15));
    CHECK((lens.k1 >= limits.low && lens.k1 <= limits.high));
    CHECK(*group.lens.limits[1] == Interval{0, 0});
    if (group.set == 0) {  // 90 degrees: all of the interval is allowed
      CHECK((std::abs(limits.low + 0.2) < 1e-15 && std::abs(limits.high - 0.2) < 1e-15));
      ++at_90;
      strong_at_90 += std::abs(lens.k1) > 0.1;
    }
    if (group.set == 6) CHECK((limits.low > -0.016 && limits.high < 0.015));  // 150 degrees
    const Pinhole& camera = group.lens.crop.camera;
    CHECK(camera.cx == 0.5 * (camera.width - 1));
    CHECK(camera.cy == 0.5 * (camera.height - 1));
  }
  CHECK((at_90 > 5 && strong_at_90 > 0 && strong_at_90 < at_90));
}

TEST_CASE("a scale makes views and cities fewer, at least three views and a city, and keeps the rest") {
  const Recipe whole = shipped("cps-v3"), hundredth = shipped("cps-v3", {"--scale", "0.01"});
  CHECK(hundredth.views.values == std::vector<int>{100, 50});
  CHECK(hundredth.cities == 1);
  CHECK(hundredth.lenses == whole.lenses);
  CHECK(hundredth.conditions_per_scene == whole.conditions_per_scene);
  CHECK(counts_of(hundredth).images == counts_of(whole).images / 100);
  CHECK(shipped("smoke", {"--scale", "1e-9"}).views == 3);
  CHECK(shipped("smoke", {"--scale", "0.2"}).city_seeds == std::vector<std::uint64_t>{11, 12});
  CHECK(to_text(shipped("cps-v2", {"--scale", "1"})) == to_text(shipped("cps-v2")));
  CHECK_THROWS_WITH(shipped("cps-v2", {"--scale", "0"}), Catch::Contains("scale: must be above 0"));
  CHECK_THROWS_WITH(shipped("cps-v2", {"--scale", "nan"}), Catch::Contains("scale: must be above 0"));
}
