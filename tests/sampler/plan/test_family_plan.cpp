#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "sampler/plan/plan.h"
#include "sampler/plan/shard.h"
#include "sampler/recipe/recipe_counts.h"
#include "tests/sampler/plain_scene.h"

using namespace cps;

namespace {

Plan plan_on_plain_ground(const Recipe& recipe) {
  REQUIRE(recipe.fault() == "");
  return make_plan(recipe, Rig{}, plan_scenes(recipe, "cities"),
                   [](const std::filesystem::path&) { return DrivenScene{.scene = plain_scene(8)}; });
}

Plan plan_of_fisheyes() {
  Recipe recipe;
  recipe.scenes = {"plain.glb"};
  recipe.sizes = {{96, 72}, {64, 64}};
  recipe.hfov_deg = {120, 195};
  recipe.views = 12;
  recipe.lens_model = "kannala_brandt";
  recipe.undistorted = false;
  recipe.lenses.values = {2, 3};
  recipe.views_per_lens = 3;
  return plan_on_plain_ground(recipe);
}

}  // namespace

TEST_CASE("every group of a plan of another family has a lens of its own that shows the set's H-FOV") {
  const Plan plan = plan_of_fisheyes();
  REQUIRE(plan.sets.size() == 4);
  CHECK(plan.sets[1].folder == "96x72_kannala_brandt_hfov195");
  CHECK(plan.sets[1].hfov_deg == 195);
  CHECK(plan.sets[3].camera.width == 64);
  std::set<std::string> folders;
  std::set<int> numbers;
  for (const PlannedGroup& group : plan.groups) {
    CHECK(folders.insert(group.folder).second);
    CHECK(numbers.insert(group.lens_number).second);
    CHECK(group.lens_number > 0);
    CHECK(group.part != Part::all);
    REQUIRE(group.model);
    CHECK(family_name(group.model->lens) == "kannala_brandt");
    const PlannedSet& set = plan.sets[group.set];
    CHECK(group.model->pinhole.width == set.camera.width);
    CHECK(group.model->pinhole.height == set.camera.height);
    const RayRegion region = certify_region(group.model->lens).region;
    CHECK(degrees(seen_hfov_rad(*group.model, region).value()) == Approx(set.hfov_deg).epsilon(1e-9));
  }
  const RecipeCounts counts = count_out(plan.recipe, 1);
  CHECK(counts.groups == static_cast<std::int64_t>(plan.groups.size()));
  CHECK(counts.views == static_cast<std::int64_t>(plan.views.size()));
  CHECK(counts.images == image_count(plan));
}

TEST_CASE("views of another family have no master and keep to their part's lenses and count their images") {
  const Plan plan = plan_of_fisheyes();
  std::map<int, int> views_of_group;
  for (const PlannedView& view : plan.views) {
    CHECK(view.master == Pinhole{});
    const int size = plan.sets[view.set].size;
    CHECK(view.groups.size() == (size == 0 ? 2u : 3u));
    CHECK(rendered_pixels(plan, view) == (size == 0 ? 2 * 96 * 72 : 3 * 64 * 64));
    for (int g : view.groups) {
      CHECK(plan.groups[g].part == view.part);
      CHECK(plan.groups[g].set == view.set);
      ++views_of_group[g];
    }
  }
  for (const auto& [group, views] : views_of_group) CHECK(views <= 3);
}

TEST_CASE("shards of another family's plan have equally many pixels to trace within a view") {
  const Plan plan = plan_of_fisheyes();
  double total = 0;
  for (const PlannedView& view : plan.views) total += rendered_pixels(plan, view);
  for (std::int64_t count : {1, 2, 5}) {
    std::int64_t next = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const ViewRange range = views_of(plan, {i, count});
      CHECK(range.begin == next);
      next = range.end;
      double pixels = 0;
      for (std::int64_t v = range.begin; v < range.end; ++v) pixels += rendered_pixels(plan, plan.views[v]);
      CHECK(std::abs(pixels - total / static_cast<double>(count)) <= 2 * 96 * 72);
    }
    CHECK(next == static_cast<std::int64_t>(plan.views.size()));
  }
}

TEST_CASE("a plan of another family is the same every time") {
  const Plan a = plan_of_fisheyes(), b = plan_of_fisheyes();
  REQUIRE(a.groups.size() == b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) CHECK(*a.groups[g].model == *b.groups[g].model);
}

TEST_CASE("recipes that differ in the lens family alone have the same places and sensors and light") {
  Recipe recipe;
  recipe.scenes = {"plain.glb"};
  recipe.conditions_per_scene = 3;
  recipe.sizes = {{64, 64}};
  recipe.hfov_deg = {75, 140};
  recipe.views = 12;
  recipe.lens_model = "unified_spherical";
  recipe.undistorted = false;
  recipe.lenses = 1;
  recipe.views_per_lens = 1;
  recipe.camera_roll_min_deg = -10;
  recipe.camera_roll_max_deg = 10;
  const Plan spherical = plan_on_plain_ground(recipe);
  recipe.lens_model = "brown_conrady";
  recipe.lens_options.scheme = LensScheme::shape_prior;
  recipe.lens_options.real_lenses_share = .3;
  const Plan flat = plan_on_plain_ground(recipe);

  REQUIRE(flat.conditions.size() == spherical.conditions.size());
  for (std::size_t c = 0; c < flat.conditions.size(); ++c)
    CHECK(flat.conditions[c].light.daylight.sun_elevation_deg ==
          spherical.conditions[c].light.daylight.sun_elevation_deg);
  REQUIRE(flat.views.size() == spherical.views.size());
  for (std::size_t v = 0; v < flat.views.size(); ++v) {
    const PlannedView &a = flat.views[v], &b = spherical.views[v];
    CHECK(a.set == b.set);
    CHECK(a.index == b.index);
    CHECK(a.condition == b.condition);
    CHECK(a.part == b.part);
    CHECK(a.street == b.street);
    CHECK((a.place.position == b.place.position));
    CHECK(a.place.heading_rad == b.place.heading_rad);
    CHECK((vehicle_from_camera(a.camera).matrix() == vehicle_from_camera(b.camera).matrix()));
    // What light paths and, with the lens' number, the sensor are drawn from.
    CHECK(a.seed == b.seed);
    REQUIRE(a.groups.size() == 1);
    REQUIRE(b.groups.size() == 1);
    CHECK(flat.groups[a.groups[0]].lens_number == spherical.groups[b.groups[0]].lens_number);
  }
}
