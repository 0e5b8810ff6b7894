#include <catch2/catch.hpp>

#include "dataset/job/recipe_json.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

TEST_CASE("the recipe in dataset.json reads back") {
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  const Recipe read = read_recipe(folder.path);
  CHECK(recipe_json(read) == recipe_json(plan.recipe));
  CHECK(read.views == 6);
  CHECK(read.base_hfov_deg == plan.recipe.base_hfov_deg);
  nlohmann::json description = read_json(folder.path / "dataset.json");
  description["recipe"]["views"] = "many";
  write_file(folder.path / "dataset.json", description.dump());
  CHECK_THROWS_WITH(read_recipe(folder.path), Catch::Contains("dataset.json: recipe: views: "));
}
