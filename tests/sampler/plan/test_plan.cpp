#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "distortion/warp/master_camera.h"
#include "sampler/plan/plan.h"
#include "tests/sampler/plain_scene.h"

using namespace cps;

namespace {

Recipe small_recipe() {
  Recipe recipe;
  recipe.scenes = {"plain.glb", "plain2.glb"};
  recipe.conditions_per_scene = 2;
  recipe.sizes = {{96, 54}, {64, 64}};
  recipe.base_hfov_deg = {60, 110};
  recipe.views = 21;
  recipe.lenses = 2;
  recipe.views_per_lens = 8;
  return recipe;
}

Plan plan_of(const Recipe& recipe) {
  return make_plan(recipe, Rig{}, plan_scenes(recipe, "cities"),
                   [](const std::filesystem::path&) { return DrivenScene{.scene = plain_scene(8)}; });
}

}  // namespace

TEST_CASE("a plan counts out what its recipe asks for") {
  const Plan plan = plan_of(small_recipe());
  CHECK(plan.conditions.size() == 4);
  REQUIRE(plan.sets.size() == 4);
  CHECK(plan.sets[0].folder == "96x54_hfov060");
  CHECK(plan.views.size() == 4 * 21);
  CHECK(image_count(plan) == 4 * 21 * 3);
  std::map<int, std::set<int>> indices;
  int last_condition = 0;
  for (const PlannedView& view : plan.views) {
    indices[view.set].insert(view.index);
    CHECK(view.condition >= last_condition);
    last_condition = view.condition;
    CHECK(view.groups.size() == 3);
  }
  for (const auto& [set, of_set] : indices) CHECK(of_set.size() == 21);
}

TEST_CASE("no lens and no street crosses the parts, and each set's parts have their share") {
  const Plan plan = plan_of(small_recipe());
  std::map<std::pair<int, std::string>, Part> part_of_street;
  std::map<std::pair<int, Part>, int> count;
  for (const PlannedView& view : plan.views) {
    const int scene = plan.conditions[view.condition].scene;
    const auto [known, is_new] = part_of_street.try_emplace({scene, view.street}, view.part);
    CHECK(known->second == view.part);
    for (int g : view.groups) {
      CHECK(plan.groups[g].set == view.set);
      CHECK((plan.groups[g].lens_number == 0 || plan.groups[g].part == view.part));
    }
    CHECK(plan.groups[view.groups[0]].lens_number == 0);
    ++count[{view.set, view.part}];
  }
  for (int set = 0; set < 4; ++set) {
    CHECK(std::abs(count[{set, Part::train}] - 0.7 * 21) <= 1);
    CHECK(count[{set, Part::val}] >= 2);
    CHECK(count[{set, Part::test}] >= 2);
  }
}

TEST_CASE("on all days of a city its streets belong to the same parts") {
  Recipe recipe = small_recipe();
  recipe.scenes = {"plain.glb"};
  recipe.city_seeds = {3, 4, 3};
  recipe.conditions_per_scene = 3;
  recipe.views = 120;
  recipe.lenses = 0;
  const Plan plan = plan_of(recipe);
  CHECK(plan.conditions.size() == 12);
  std::map<std::pair<std::uint64_t, std::string>, std::pair<Part, std::set<int>>> seen;
  for (const PlannedView& view : plan.views) {
    const int scene = plan.conditions[view.condition].scene;
    const std::uint64_t city = plan.scenes[scene].city ? plan.scenes[scene].city->seed : 0;
    auto& [part, scenes] = seen.try_emplace({city, view.street}, view.part, std::set<int>{}).first->second;
    CHECK(part == view.part);
    scenes.insert(scene);
  }
  bool on_many_days = false;
  for (const auto& [street, what] : seen) on_many_days |= what.second.size() >= 6;
  CHECK(on_many_days);
}

TEST_CASE("lens numbers are unique and lens blocks hold no more views than they may") {
  const Plan plan = plan_of(small_recipe());
  std::set<std::string> folders;
  std::set<int> numbers;
  for (const PlannedGroup& group : plan.groups) {
    CHECK(folders.insert(group.folder).second);
    if (group.lens_number > 0) CHECK(numbers.insert(group.lens_number).second);
  }
  std::map<int, int> views_of_group;
  for (const PlannedView& view : plan.views)
    for (int g : view.groups) ++views_of_group[g];
  for (const auto& [g, views] : views_of_group)
    if (plan.groups[g].lens_number > 0) CHECK(views <= 8);
}

TEST_CASE("base-first, every view of a set has the same twofold master") {
  const Plan plan = plan_of(small_recipe());
  for (const PlannedView& view : plan.views)
    CHECK(view.master ==
          master_camera(plan.sets[view.set].camera, WarpOptions{}, LensBounds{}.min_eigenvalue));
}

TEST_CASE("label-first, images share their set's H-FOV, and a view's master serves the widest base") {
  Recipe recipe = small_recipe();
  std::swap(recipe.hfov_deg, recipe.base_hfov_deg);
  recipe.lens_options.scheme = LensScheme::shape_prior;
  const Plan plan = plan_of(recipe);
  CHECK(plan.sets[1].folder == "96x54_hfov110");
  for (const PlannedGroup& group : plan.groups)
    CHECK(group.lens.crop.camera.fx == Approx(plan.sets[group.set].camera.fx).epsilon(1e-9));
  for (const PlannedView& view : plan.views) {
    const Eigen::AlignedBox2d master = frame_on_plane(view.master);
    for (int g : view.groups) CHECK(master.contains(frame_on_plane(plan.groups[g].lens.base)));
    CHECK(view.master.width < 5 * plan.sets[view.set].camera.width);
  }
}

TEST_CASE("places lie on their street, near the lane, facing along it") {
  const Recipe recipe = small_recipe();
  const Plan plan = plan_of(recipe);
  const Scene scene = plain_scene(8);
  for (const PlannedView& view : plan.views) {
    double nearest = 1e9;
    for (const Lane& lane : scene.lanes)
      if (lane.street == view.street) {
        const bool runs_along_x = lane.points[1].x() > lane.points[0].x();
        const bool faces_along_x = std::cos(view.place.heading_rad) > 0;
        if (runs_along_x == faces_along_x)
          nearest = std::min(nearest, std::abs(view.place.position.z() - lane.points[0].z()));
      }
    CHECK(nearest < 6 * recipe.lateral_m);
    CHECK(std::abs(view.place.position.x()) <= 150);
    CHECK(std::abs(std::sin(view.place.heading_rad)) < std::sin(6 * recipe.heading_deg * 3.1416 / 180));
  }
}

TEST_CASE("all cameras of a rig see one place, each through lenses of its own") {
  const Rig rig{.cameras = {{.name = "left", .position_m = {1, 0.5, 1.5}, .yaw_deg = 20},
                            {.name = "right", .position_m = {1, -0.5, 1.5}}}};
  const Recipe recipe = small_recipe();
  const Plan plan = make_plan(recipe, rig, plan_scenes(recipe, "cities"), [](const std::filesystem::path&) {
    return DrivenScene{.scene = plain_scene(8)};
  });
  CHECK(plan.views.size() == 2 * 4 * 21);
  std::set<std::string> folders;
  for (std::size_t v = 0; v < plan.views.size(); v += 2) {
    const PlannedView &left = plan.views[v], &right = plan.views[v + 1];
    CHECK(std::pair(left.set, left.index) == std::pair(right.set, right.index));
    CHECK(left.place.position == right.place.position);
    CHECK(left.part == right.part);
    CHECK(left.seed != right.seed);
    CHECK(left.camera.name == "left");
    CHECK(right.camera.name == "right");
    CHECK(left.camera.yaw_deg - 20 != right.camera.yaw_deg);  // each has a mount error of its own
    CHECK(std::abs(left.camera.yaw_deg - 20) < 6 * recipe.mount_error_deg);
    const double off_m = (right.camera.position_m - rig.cameras[1].position_m).norm();
    CHECK(off_m > 0);
    CHECK(off_m < 8 * recipe.mount_error_m);
    for (std::size_t g = 0; g < left.groups.size(); ++g) {
      const PlannedGroup &of_left = plan.groups[left.groups[g]], &of_right = plan.groups[right.groups[g]];
      CHECK(of_left.camera == 0);
      CHECK(of_right.camera == 1);
      CHECK((of_left.lens_number == of_right.lens_number) == (of_left.lens_number == 0));
    }
  }
  for (const PlannedGroup& group : plan.groups) CHECK(folders.insert(group.folder).second);
  CHECK(folders.contains("96x54_hfov060/left_lens0000"));
  CHECK(folders.contains("96x54_hfov060/right_lens0000"));
  CHECK(plan.places.drawn - plan.places.rejected() == 4 * 21);
}

TEST_CASE("a plan is the same every time and follows its seed") {
  const Plan a = plan_of(small_recipe()), b = plan_of(small_recipe());
  REQUIRE(a.views.size() == b.views.size());
  for (std::size_t v = 0; v < a.views.size(); ++v) {
    CHECK(a.views[v].place.position == b.views[v].place.position);
    CHECK(a.views[v].seed == b.views[v].seed);
  }
  for (std::size_t g = 0; g < a.groups.size(); ++g)
    CHECK(a.groups[g].lens.distortion == b.groups[g].lens.distortion);
  Recipe other = small_recipe();
  other.seed = 1;
  CHECK(plan_of(other).views[0].place.position != a.views[0].place.position);
}

TEST_CASE("scenes that cannot carry a plan are refused by name") {
  const Recipe recipe = small_recipe();
  const auto plan_on = [&](int streets) {
    return make_plan(recipe, Rig{}, {{.file = "plain.glb"}}, [&](const std::filesystem::path&) {
      return DrivenScene{.scene = plain_scene(streets)};
    });
  };
  CHECK_THROWS_WITH(plan_on(0), Catch::Contains("plain.glb") && Catch::Contains("lanes"));
  CHECK_THROWS_WITH(plan_on(2), Catch::Contains("2 streets") && Catch::Contains("split = thesis"));
  Recipe doubled = recipe;
  doubled.base_hfov_deg = {60, 60.2};
  CHECK_THROWS_WITH(plan_of(doubled), Catch::Contains("96x54_hfov060"));
}
